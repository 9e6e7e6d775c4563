// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/true_boxes.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness::evaluation {

/// How far a box is from a true one. A box has no front: the axes of the found one are called by the names, of the 24
/// that keep it the same box, with which it is turned least against the true one.
struct BoxErrors {
  double overlap = 0;             ///< intersection over union
  double centre_mm = 0;           ///< distance of the centres
  std::optional<double> yaw_deg;  ///< absolute turn about `up`; none of round things
  /// Found minus true: the longer and the shorter side of the true box across `up` and the one along it.
  Eigen::Vector3d sides_mm = Eigen::Vector3d::Zero();
};

/// round: truth is of a solid of revolution about its own z axis. Any turn about that is as true as any other, and the
/// one of most overlap is taken. up: unit vector away from the table. All in one frame.
BoxErrors compareBoxes(const OrientedBox& found, const OrientedBox& truth, bool round, const Eigen::Vector3d& up);

/// The box of one object of a scene whose true boxes are known (objects.yaml), beside that of its segment.
struct BoxFit {
  int object = -1;  ///< trueObject() of its labels
  std::string kind;
  double dice = 0;            ///< of it and its segment; 0: it has none, and all else is 0
  BoxErrors errors;           ///< of the segment's box
  double points_overlap = 0;  ///< of the upright box around the segment's visible points

  /// Only then do errors tell of the box: Dice over 0.75, as Scores::found_75.
  bool isSegmented() const;
};

/// The box of each segment. Those without one of their own (of baselines) get the upright one around their visible
/// points, of no size where there is no surface.
std::vector<OrientedBox> segmentBoxes(const Frame& frame, const Segmentation& found);

/// A fit for each true box, in their order. Objects and segments are paired as for Scores; boxes are segmentBoxes().
/// true_labels: as in labels.png.
std::vector<BoxFit> measureBoxFits(const Frame& frame, const Segmentation& found, const cv::Mat_<ushort>& true_labels,
                                   const std::vector<TrueBox>& truth);

}  // namespace objectness::evaluation

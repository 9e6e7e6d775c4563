// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "evaluation/metrics.hpp"
#include "evaluation/run.hpp"
#include "evaluation/scene_result.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// What a method found in one frame of a scene that stands still before a camera that does.
struct StillFrame {
  cv::Mat_<ushort> labels;         ///< 0 nothing, 1 table, 2 + i: boxes[i]
  std::vector<OrientedBox> boxes;  ///< camera frame
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
};

/// How much the results of a still scene differ from frame to frame. Segments of a frame and the next are paired one to
/// one, the sum of their overlaps being the largest; those that overlap by half at least are one identity. Columns:
/// frames; count, mean number of segments; count_spread, its standard deviation; switches, segments a frame that the
/// next one has no partner for; segment_IoU, mean overlap of partners; turn_median_deg and turn_max_deg, turns about
/// `up` between the boxes of partners (BoxErrors::yaw_deg); and centre_spread_mm and side_spread_mm, root mean square
/// of the distance of an identity's centres, and of its sides, from their means. Empty for fewer than two frames.
Metrics measureStability(const std::vector<StillFrame>& frames);

/// The stability of a method over the scenes of a data set, which are frames in the order of their names.
struct StabilityRow {
  std::string method, sequence;
  Metrics columns;
};

/// Reads the labels that the report holds. Data sets with a frame without result are left out. kBadInput: labels that
/// cannot be read.
Result<std::vector<StabilityRow>> summarizeStability(const std::string& report, const Run& run,
                                                     const std::vector<SceneResult>& results);

/// The table as text, the way it is shown on a terminal; empty without rows.
std::string toText(const std::vector<StabilityRow>& rows);

/// Writes stability.csv, a row a method and sequence.
Status writeStability(const std::string& report, const std::vector<StabilityRow>& rows);

}  // namespace objectness::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness::evaluation {

struct TrueBox {
  int object = -1;  ///< trueObject() of its labels
  OrientedBox box;
  std::string kind = {};  ///< "box", "mug", ...; empty where it is not known

  /// A solid of revolution about the box's z axis, by its kind: which way it is turned about it cannot be told.
  bool isRound() const;
};

/// The boxes of objects.yaml in a scene folder, as simulated scenes have it:
///     objects:
///       - {label: 20, kind: mug, size_m: [x, y, z], T_camera_box: {position: [x, y, z], orientation_xyzw: [x, y, z,
///       w]}}
/// position is the box's centre; kind may be missing. Empty when there is no such file or its entries are of another
/// kind (without size_m); kBadInput with the reason when an entry cannot be read.
Result<std::vector<TrueBox>> loadTrueBoxes(const std::string& scene_folder);

/// Those of them of objects that some pixel shows. labels: as SceneImages::true_labels.
Result<std::vector<TrueBox>> loadVisibleTrueBoxes(const std::string& scene_folder, const cv::Mat_<ushort>& labels);

/// For scenes of which labels are all that is known: for each object the upright box from the table to its top over the
/// smallest rectangle about its visible points. Single points off its surface are left out. What is hidden of an object
/// is not in its box, and what it stands on, other than the table, is. labels: H x W as SceneImages::true_labels.
std::vector<TrueBox> fitTrueBoxes(const Frame& frame, const Table& table, const cv::Mat_<ushort>& labels);

/// The true boxes of a scene: those of the file when it has them, else fitted. Objects that no pixel shows are left
/// out. labels of the frame's size.
Result<std::vector<TrueBox>> findTrueBoxes(const std::string& scene_folder, const Frame& frame, const Table& table,
                                           const cv::Mat_<ushort>& labels);

}  // namespace objectness::evaluation

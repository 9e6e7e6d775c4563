// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/run.hpp"
#include "evaluation/scene_result.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// The metrics of a method over the scenes of a camera (a data set), or of a group of its scenes.
struct CameraRow {
  std::string method, camera;
  std::string group;  ///< "": all scenes of the camera
  int scenes = 0;     ///< with truth
  /// Means over the scenes with labels, at object level; none where no scene has any.
  std::optional<Scores> labels;
  int labelled = 0;  ///< scenes in these means
  /// Sums over the scenes with boxes in the picture; none where no scene has any.
  std::optional<PictureBoxCounts> boxes;
  double ms = 0;  ///< median
};

/// By method, in the order of the run, then by camera; the groups of a camera come before its own row. Scenes that a
/// method was not run in count nowhere. A method without any scored scene of a camera has no row of it.
std::vector<CameraRow> summarizeCameras(const Run& run, const std::vector<SceneResult>& results);

/// The table as text, the way it is shown on a terminal; empty without rows.
std::string toText(const std::vector<CameraRow>& rows);

/// Writes cameras.csv (the rows of summarizeCameras()) and picture_boxes.csv (a row a method and scene with boxes).
Status writeCameraTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results);

}  // namespace objectness::evaluation

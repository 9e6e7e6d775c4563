// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluation/metrics.hpp"
#include "evaluation/run.hpp"
#include "evaluation/scene_result.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// How well a method's boxes fit some of the objects whose true boxes are known.
struct BoxRow {
  std::string method;
  std::string by;    ///< "all", "group" or "kind"
  std::string name;  ///< of the group or kind
  /// Columns: objects; segmented, of which the segment has a Dice over 0.75; IoU_all, mean over all of these objects
  /// (0 without a segment). Then over those segmented: IoU, mean intersection over union; IoU50 and IoU70, share over
  /// 0.5 and 0.7; points_IoU, points50 and points70, the same of the upright box around their visible points; means
  /// of centre_mm and of the absolute errors yaw_deg (of those with a yaw), long_mm, short_mm and height_mm; and
  /// sides_10mm, share with all three sides within 10 mm.
  Metrics columns;
};

/// By method, in the order of the run: all objects, then by group (a group "all" has no row), then by kind.
std::vector<BoxRow> summarizeBoxes(const Run& run, const std::vector<SceneResult>& results);

/// The table as text, the way it is shown on a terminal; empty without rows.
std::string toText(const std::vector<BoxRow>& rows);

/// Writes boxes.csv (the rows of summarizeBoxes()) and objects.csv (a row a method, scene and object).
Status writeBoxTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results);

}  // namespace objectness::evaluation

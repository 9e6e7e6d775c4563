// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/box_fits.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/picture_boxes.hpp"
#include "evaluation/scores.hpp"
#include "objectness_segmentation/common/stage_timer.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// What one method did in one scene; kept as \<report\>/results/\<method\>/\<scene\>.json.
struct SceneResult {
  enum class State {
    kDone,
    kFailed,        ///< the method did; scored as if nothing had been found
    kUnusable,      ///< there is no truth to score against
    kNotApplicable  ///< the method is told true labels, and the scene has none
  };

  std::string scene, method;
  std::string made_from;  ///< commit, settings and input in one text: equal text, equal result
  State state = State::kDone;
  std::string problem;                            ///< of a state other than kDone, a sentence
  std::optional<Scores> object, part;             ///< by level; none when the truth has no objects
  std::optional<PictureBoxCounts> picture_boxes;  ///< where objects.yaml has boxes in the picture
  std::vector<BoxFit> box_fits;                   ///< where objects.yaml has boxes in space
  std::vector<OrientedBox> segment_boxes;         ///< segmentBoxes()
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< away from the table, camera frame
  int segments = 0;
  Metrics proposals;      ///< toMetrics(), of methods that propose boxes
  Metrics gaps;           ///< selection_gap and annealing_gap of the Report, where there are any
  StageTimes timings_ms;  ///< as in Report
  double peak_mib = 0;    ///< most memory its process held until the segments were there

  const std::optional<Scores>& scores(Level level) const { return level == Level::kObject ? object : part; }
  std::optional<double> totalMs() const;
};

/// \<report\>/results/\<method\>/\<scene\> without an extension.
std::string resultPath(const std::string& report, const std::string& method, const std::string& scene);

Status saveResult(const std::string& report, const SceneResult& result);

/// kBadInput when there is none or it cannot be read.
Result<SceneResult> loadResult(const std::string& report, const std::string& method, const std::string& scene);

}  // namespace objectness::evaluation

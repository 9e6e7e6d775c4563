// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluation/run.hpp"
#include "evaluation/scene_result.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// The metrics of a method at one level over the scenes of a group.
struct SummaryRow {
  std::string method, level;
  std::string group;  ///< "ALL": every scene
  Metrics columns;    ///< scenes, means of Scores, ms (median), peak_mib (largest)
  Metrics proposals;  ///< poolProposals(), at object level
  Metrics gaps;       ///< poolGaps(), at object level
};

/// One row a method, level and group that has scored scenes, ALL last; a group of the name "all" has none of its own.
std::vector<SummaryRow> summarize(const Run& run, const std::vector<SceneResult>& results);

/// The table as text, the way it is shown on a terminal.
std::string toText(const std::vector<SummaryRow>& rows);

/// Writes scenes.csv (a row a method, level and scene; cells that do not apply are empty) and summary.json ({method:
/// {level: {group: {column: value}}}}).
Status writeTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results);

}  // namespace objectness::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluation/proposals.hpp"

namespace objectness::evaluation {

/// Named metrics, in the order of the columns of tables.
using Metrics = std::vector<std::pair<std::string, double>>;

/// What a scene says about proposals, by column: boxed_objects, proposals, best_P and best_R (paper, Fig. 4 (c)), then
/// for each number N of boxes kept the recall of true objects at an overlap of 0.5 and 0.7: box50_N and box70_N of the
/// method's boxes, fixed50_N and fixed70_N of the fixed list.
Metrics toMetrics(const ProposalMetrics& proposals);

/// Over scenes: boxed_objects summed up, the rest means over the scenes that have metrics. Empty when none has.
Metrics poolProposals(const std::vector<Metrics>& scenes);

/// Over the scenes that have it, of each figure its mean and, as NAME_max, the largest.
Metrics poolGaps(const std::vector<Metrics>& scenes);

}  // namespace objectness::evaluation

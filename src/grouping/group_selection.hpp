// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "grouping/group_cues.hpp"
#include "grouping/propose_groups.hpp"
#include "objectness_segmentation/grouping/cue_switches.hpp"
#include "objectness_segmentation/grouping/grouping_config.hpp"
#include "segments/segments.hpp"
#include "selection/set_packing.hpp"

namespace objectness {

/// Value of each group for the packing: the log odds of its inner links, and weight_objectness times its objectness
/// over least_objectness for each of its pieces; a
/// remembered group has memory_objectness more. The sum of links keeps large groups from being joined for a few good
/// cues.
PackingProblem packingProblem(int pieces, const std::vector<Link>& links, const std::vector<GroupHypothesis>& groups,
                              const GroupingConfig& config);

/// The groups of the best packing found, proven best where branch and bound gets through or annealing reaches the
/// bound.
Packing selectGroups(const PackingProblem& problem, const GroupingConfig& config, unsigned seed);

/// The chosen groups as segments, best objectness first; a piece in several of them is the best one's. Groups of fewer
/// than config.min_pixels are left out.
std::vector<Segment> cutGroups(const Pieces& pieces, const std::vector<GroupHypothesis>& groups,
                               const std::vector<int>& chosen, const SegmentsConfig& config);

}  // namespace objectness

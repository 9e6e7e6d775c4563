// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/bottom_up.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"

namespace objectness {

/// The model that config asks for: `given`, or where that is nullptr the one that comes with the package; nullptr where
/// links and groups are judged by rules set by hand (grouping.learned).
const LearnedObjectness* judgeOf(const Config& config, const LearnedObjectness* given);

/// How likely the pairs are parts of one object. model: nullptr for the rules.
std::vector<Link> judgeLinks(const PieceGraph& graph, const LearnedObjectness* model, int threads);

/// Fills in the objectness of the groups. model: nullptr for Eq. 6 of the groups' boxes.
void judgeObjects(const Config& config, const LearnedObjectness* model, std::vector<GroupHypothesis>& groups);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "grouping/group_selection.hpp"

namespace objectness {

/// Groups of pieces that no chosen group has and that surely stand on the table: connected pieces that touch nothing
/// that was chosen, are seen down to what carries them and surrounded by it, show enough surface, and lie over the
/// noise, far over it where their outline is ragged. Whatever a model makes of their shape, something is there. Indices
/// of `groups` that share no piece: the best packing of these. chosen: indices of `groups`.
std::vector<int> standingGroups(const Frame& frame, const Table& table, const ObjectPoints& above, const Pieces& pieces,
                                const std::vector<Link>& links, const std::vector<GroupHypothesis>& groups,
                                const std::vector<int>& chosen, const GroupingConfig& config, unsigned seed);

}  // namespace objectness

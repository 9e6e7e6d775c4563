// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "grouping/group_cues.hpp"
#include "objectness/objectness.hpp"
#include "selection/global_cost.hpp"

namespace objectness {

/// What the free space and the objectness of a group are counted in: as those of the paper's boxes.
struct GroupCostUnits {
  const ObjectnessConfig& objectness;
  double voxel_m;
};

/// The groups as the cost of Eq. 8 sees them, for grouping.paper_cost. The scene points S' are those of all pieces, of
/// each piece one a cell of config.point_spacing_m. A group holds the points of its pieces, whole; in its surroundings
/// are the points of other pieces in its box grown by config.ring_m on its four sides and upwards, inside the box too:
/// the paper's box would hold them. delta(b) is the objectness that the group was judged by, free space that of
/// paperCues(). Alike points are merged.
CostProblem groupCostProblem(const Frame& frame, const Table& table, const Pieces& pieces,
                             const std::vector<GroupHypothesis>& groups, const SelectionConfig& config,
                             const GroupCostUnits& units);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "grouping/group_cues.hpp"
#include "objectness/objectness.hpp"

namespace objectness {

// What judges pairs and groups with grouping.learned off: rules and the paper's weights, no learned number in either.

/// Links by rule. A contact is one with certainty where its median signed angle is over -35 degrees, and none with
/// certainty elsewhere. A gap is one with certainty where its sides are coplanar (cosine over 0.97, neither centroid
/// farther than 10 mm from the other's plane) and hidden (occluded share over 0.4, free share under 0.1); elsewhere it
/// says nothing, and there is no link.
std::vector<Link> scorePairsByRule(const std::vector<PairEvidence>& evidence, const Pieces& pieces,
                                   const Borders& borders);

/// The cues of Eq. 1, 2, 4 and 5 of a group's own tight box, in voxels as those of the paper's boxes, so that the
/// weights mean the same: edges by length, volumes by share. Points count where the paper counts occupied voxels.
CueValues paperCues(const GroupHypothesis& group, const ObjectnessConfig& config, double voxel_m);

/// Sets the objectness of each group to Eq. 6 of its tight box plus `shift`, clamped to 0..1: what the packing weighs
/// against least_objectness. With a shift of least_objectness - FilterConfig::threshold a group is rather left out
/// where the paper leaves its box out. The gates (ObjectnessConfig::min_*), which keep out boxes of little or nothing,
/// do not apply: groups are whole pieces.
void scoreGroupsByRule(const ObjectnessConfig& config, double voxel_m, double shift,
                       std::vector<GroupHypothesis>& groups);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/selection/selection_config.hpp"
#include "reference/point_overlap.hpp"

namespace objectness {

/// A box that survived, with the scene points it holds.
struct BoxHypothesis {
  ScoredBox scored;
  PointSet points;
};

/// Clusters the boxes by centre (leaders are taken best first), keeps the max_boxes_per_cluster best of each, and of
/// boxes in conflict the best. boxes: sorted by better(); grids and overlaps: one per angle. Returns B*, best first.
std::vector<BoxHypothesis> filterBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                       const std::vector<PointOverlap>& overlaps, const FilterConfig& config);

}  // namespace objectness

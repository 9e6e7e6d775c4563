// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/selection/selection_config.hpp"
#include "selection/box_points.hpp"

namespace objectness {

/// A box that survived, with the scene points it holds.
struct SurvivingBox {
  ScoredBox scored;
  PointBits points;
};

/// Clusters the boxes by centre (leaders are taken best first), keeps the max_boxes_per_cluster best of each, and of
/// boxes in conflict the best (paper Sec. 4.1). boxes: sorted by better(). The same boxes, best first, as one by one
/// (test/reference/plain_filter.hpp), on sets of points in groups: most boxes are in conflict with one that
/// suppressed a box of their cluster just before, which is asked first. Boxes are looked at in batches, on up to
/// `threads` threads: against what was kept before the batch at once, against what is kept of the batch itself one by
/// one.
std::vector<SurvivingBox> suppressBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                        const std::vector<BoxPoints>& points, const PointLayout& layout,
                                        const FilterConfig& config, int threads);

}  // namespace objectness

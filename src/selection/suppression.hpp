// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "box_points.hpp"
#include "objectness_segmentation/selection/box_filter.hpp"

namespace objectness {

/// A box that survived, with the scene points it holds.
struct SurvivingBox {
  ScoredBox scored;
  PointBits points;
};

/// What filterBoxes() does, the same boxes, on sets of points in groups: most boxes are in conflict with one that
/// suppressed a box of their cluster just before, which is asked first.
std::vector<SurvivingBox> suppressBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                        const std::vector<BoxPoints>& points, const PointLayout& layout,
                                        const FilterConfig& config);

}  // namespace objectness

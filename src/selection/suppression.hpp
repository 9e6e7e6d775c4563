// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "selection/box_filter.hpp"
#include "selection/box_points.hpp"

namespace objectness {

/// A box that survived, with the scene points it holds.
struct SurvivingBox {
  ScoredBox scored;
  PointBits points;
};

/// What filterBoxes() does, the same boxes, on sets of points in groups: most boxes are in conflict with one that
/// suppressed a box of their cluster just before, which is asked first. Boxes are looked at in batches, on up to
/// `threads` threads: against what was kept before the batch at once, against what is kept of the batch itself one by
/// one.
std::vector<SurvivingBox> suppressBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                        const std::vector<BoxPoints>& points, const PointLayout& layout,
                                        const FilterConfig& config, int threads);

}  // namespace objectness

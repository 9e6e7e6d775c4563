// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "integral/grid.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/selection/selection_config.hpp"
#include "selection/bit_selection.hpp"

namespace objectness {

/// B* of paper Sec. 4.1: the boxes that survived the filtering, ready for the global selection.
struct Hypotheses {
  std::vector<ScoredBox> boxes;  ///< best first
  BitProblem problem;            ///< the same as the cost of Eq. 8 sees them
};

/// Sec. 4.1: filters the scored boxes (best first, one grid per angle) by what they hold of the scene's points (table
/// frame, metres). Does not depend on the number of threads.
Hypotheses filterByObjectness(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                              const std::vector<Eigen::Vector3f>& points, const FilterConfig& filter,
                              const SelectionConfig& selection, int threads);

}  // namespace objectness

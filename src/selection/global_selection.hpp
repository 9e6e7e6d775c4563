// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "selection/global_cost.hpp"

namespace objectness {

/// Which hypotheses are chosen, and what was found on the way.
struct Selection {
  std::vector<bool> active;  ///< x_i of Eq. 7
  double cost = 0;           ///< F of Eq. 8 at `active`
};

/// Eq. 7: minimizes the cost by simulated annealing from the empty selection, cooled geometrically from
/// start_temperature to end_temperature, ended by descent to a local minimum; the best selection ever met is returned.
/// Moves: flips, swaps of an active with an inactive box, and takeovers (a box is activated in the place of all active
/// ones that hold points of it). The same problem and seed give the same selection.
Selection selectHypotheses(const CostProblem& problem, const SelectionConfig& config, unsigned seed);

}  // namespace objectness

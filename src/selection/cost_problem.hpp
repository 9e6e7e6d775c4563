// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace objectness {

/// A hypothesis as the cost of Eq. 8 sees it.
struct CostHypothesis {
  double objectness = 0;          ///< delta(b)
  double free_space = 0;          ///< what lambda weighs
  std::vector<int> inside;        ///< scene points in b, ascending
  std::vector<int> surroundings;  ///< scene points in b_eps but not in b, ascending
};

/// What the global selection chooses from.
struct CostProblem {
  std::vector<CostHypothesis> hypotheses;
  std::vector<int> weights;  ///< of each point the hypotheses name: how many scene points it stands for
};

/// Replaces all points that lie in the same boxes and the same surroundings by one of their number's weight, and leaves
/// out those in none: the cost of every selection stays what it was, for a fraction of the points.
CostProblem mergeAlikePoints(const std::vector<CostHypothesis>& hypotheses, int points);

}  // namespace objectness

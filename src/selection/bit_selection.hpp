// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "selection/global_selection.hpp"
#include "selection/point_bits.hpp"

namespace objectness {

/// CostHypothesis with its points as bits.
struct BitHypothesis {
  double objectness = 0;   ///< delta(b)
  double free_space = 0;   ///< what lambda weighs
  PointBits inside;        ///< scene points in b
  PointBits surroundings;  ///< scene points in b_eps but not in b
};

/// What the global selection chooses from, as bits.
struct BitProblem {
  PointLayout layout;
  std::vector<BitHypothesis> hypotheses;
};

/// The same problem with lists of points.
CostProblem listProblem(const BitProblem& problem);

/// selectHypotheses() of listProblem(), to the last bit: the same moves, their gains counted on bit sets.
Selection selectHypotheses(const BitProblem& problem, const SelectionConfig& config, unsigned seed);

}  // namespace objectness

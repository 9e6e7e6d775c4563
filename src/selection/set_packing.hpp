// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace objectness {

/// Choose sets, no two of which share an element, so that the sum of their values is largest.
struct PackingProblem {
  int elements = 0;
  std::vector<std::vector<int>> sets;  ///< ascending element indices, none empty
  std::vector<double> values;          ///< one per set; sets of value <= 0 are never chosen
};

struct Packing {
  std::vector<int> chosen;  ///< indices of sets, ascending
  double value = 0;
  double bound = 0;      ///< no choice is worth more; equal to value when the choice is proven best
  bool optimal = false;  ///< proven

  /// What is missing to the bound at most, as a share of it: 0 when proven best.
  double gap() const { return optimal || bound <= 0 ? 0 : std::max(0.0, bound - value) / bound; }
};

/// Branch and bound over the connected parts of the problem. Gives up proving (not choosing) after max_nodes: the best
/// choice found until then is returned with the bound that is left.
Packing packExactly(const PackingProblem& problem, std::int64_t max_nodes);

/// Simulated annealing: a set comes in and throws out those it shares elements with, or goes. Deterministic for a seed.
/// bound is that of the elements' best shares.
Packing packByAnnealing(const PackingProblem& problem, int iterations, std::uint32_t seed);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "selection/bit_selection.hpp"

#include "selection/annealer.hpp"
#include "selection/bit_cost.hpp"

namespace objectness {
namespace {

std::vector<int> listOf(const PointBits& set) {
  std::vector<int> list;
  for (std::size_t w = 0; w < set.words.size(); ++w) {
    for (std::uint64_t left = set.words[w]; left != 0; left &= left - 1) {
      list.push_back(static_cast<int>(w) * 64 + __builtin_ctzll(left));
    }
  }
  return list;
}

}  // namespace

CostProblem listProblem(const BitProblem& problem) {
  CostProblem lists;
  lists.weights.assign(problem.layout.points, 1);
  for (const BitHypothesis& h : problem.hypotheses) {
    lists.hypotheses.push_back({h.objectness, h.free_space, listOf(h.inside), listOf(h.surroundings)});
  }
  return lists;
}

Selection selectHypotheses(const BitProblem& problem, const SelectionConfig& config, unsigned seed) {
  return Annealer<BitCost>(problem, config, seed).run();
}

}  // namespace objectness

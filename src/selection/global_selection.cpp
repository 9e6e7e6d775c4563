// SPDX-License-Identifier: BSD-3-Clause
#include "selection/global_selection.hpp"

#include "selection/annealer.hpp"
#include "selection/point_set.hpp"

namespace objectness {
namespace {

/// For each hypothesis the others that hold one of its points.
std::vector<std::vector<int>> findRivals(const CostProblem& problem) {
  const std::vector<CostHypothesis>& hypotheses = problem.hypotheses;
  std::vector<PointSet> held(hypotheses.size(), PointSet((problem.weights.size() + 63) / 64, 0));
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    for (const int p : hypotheses[i].inside) held[i][p / 64] |= std::uint64_t{1} << (p % 64);
  }
  std::vector<std::vector<int>> rivals(hypotheses.size());
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    for (std::size_t j = i + 1; j < hypotheses.size(); ++j) {
      if (!sharePoints(held[i], held[j])) continue;
      rivals[i].push_back(static_cast<int>(j));
      rivals[j].push_back(static_cast<int>(i));
    }
  }
  return rivals;
}

/// The cost counted point by point, and every move tried every time: the definition of the result.
class PlainCost {
 public:
  PlainCost(const CostProblem& problem, const SelectionConfig& config)
      : counted_(problem, config), rivals_(findRivals(problem)) {}

  double cost() const { return cost_; }
  const std::vector<bool>& active() const { return counted_.active(); }
  int size() const { return counted_.size(); }
  double flipDelta(int i) const { return counted_.flipDelta(i); }
  double flip(int i) {
    const double delta = counted_.flip(i);
    cost_ += delta;
    return delta;
  }
  void undo(const std::vector<int>& flips, double cost) {
    for (const int i : flips) counted_.flip(i);
    cost_ = cost;
  }
  std::vector<int> rivals(int i, bool active) const {
    std::vector<int> found;
    for (const int rival : rivals_[i]) {
      if (counted_.active()[rival] == active) found.push_back(rival);
    }
    return found;
  }
  bool settled(int) const { return false; }
  void settle(int) {}
  void changed(const std::vector<int>&) {}

 private:
  GlobalCost counted_;
  const std::vector<std::vector<int>> rivals_;
  double cost_ = 0;  // its own: undone flips leave no rounding in it
};

}  // namespace

Selection selectHypotheses(const CostProblem& problem, const SelectionConfig& config, unsigned seed) {
  return Annealer<PlainCost>(problem, config, seed).run();
}

}  // namespace objectness

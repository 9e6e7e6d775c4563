// SPDX-License-Identifier: BSD-3-Clause
#include "selection/global_cost.hpp"

#include <map>

#include "selection/cost_change.hpp"

namespace objectness {

GlobalCost::GlobalCost(const CostProblem& problem, const SelectionConfig& config)
    : problem_(problem), config_(config), points_(problem.weights.size()), active_(problem.hypotheses.size(), false) {}

double GlobalCost::flipDelta(int i) const {
  const CostHypothesis& h = problem_.hypotheses[i];
  CostChange change;
  change.step = active_[i] ? -1 : 1;
  std::map<int, long> owned;  // change of the points that are in this box alone
  const auto count = [&](const PointState& state, long weight) {
    if (state.holders > 1) change.multiple += weight * state.holders;
    if (state.holders == 1) owned[static_cast<int>(state.holders_sum)] += weight;
    if (state.holders == 0) change.unexplained += weight * state.neighbours;
  };
  for (const int p : h.inside) {
    PointState state = points_[p];
    count(state, -problem_.weights[p]);
    state.holders += change.step;
    state.holders_sum += change.step * i;
    count(state, problem_.weights[p]);
  }
  for (const int p : h.surroundings) {
    if (points_[p].holders == 0) change.unexplained += change.step * problem_.weights[p];
  }
  for (const auto& [box, points] : owned) {
    change.objectness += problem_.hypotheses[box].objectness * static_cast<double>(points);
  }
  return costOf(change, h.free_space, config_);
}

double GlobalCost::flip(int i) {
  const double delta = flipDelta(i);
  const CostHypothesis& h = problem_.hypotheses[i];
  const int step = active_[i] ? -1 : 1;
  for (const int p : h.inside) {
    points_[p].holders += step;
    points_[p].holders_sum += step * i;
  }
  for (const int p : h.surroundings) points_[p].neighbours += step;
  active_[i] = !active_[i];
  cost_ += delta;
  return delta;
}

double GlobalCost::evaluate(const CostProblem& problem, const SelectionConfig& config,
                            const std::vector<bool>& active) {
  const std::vector<CostHypothesis>& hypotheses = problem.hypotheses;
  const std::size_t points = problem.weights.size();
  std::vector<double> held(points, 0), objectness_of_holders(points, 0), beside(points, 0);
  double cost = 0;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (!active[i]) continue;
    cost += config.lambda * hypotheses[i].free_space;
    for (const int p : hypotheses[i].inside) {
      held[p] += 1;
      objectness_of_holders[p] += hypotheses[i].objectness;
    }
    for (const int p : hypotheses[i].surroundings) beside[p] += 1;
  }
  for (std::size_t p = 0; p < points; ++p) {
    double weight = 0;
    if (held[p] > 1) {
      weight = config.weight_multiple * held[p];
    } else if (held[p] == 1) {
      weight = -config.weight_objectness * objectness_of_holders[p];
    } else {
      weight = config.weight_unexplained * beside[p];
    }
    cost += problem.weights[p] * weight;
  }
  return cost;
}

}  // namespace objectness

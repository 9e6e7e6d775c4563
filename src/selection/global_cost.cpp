// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/global_cost.hpp"

namespace objectness {

GlobalCost::GlobalCost(const CostProblem& problem, const SelectionConfig& config)
    : problem_(problem), config_(config), points_(problem.weights.size()), active_(problem.hypotheses.size(), false) {}

double GlobalCost::weightOf(const PointState& state) const {
  if (state.holders > 1) return config_.weight_multiple * state.holders;
  if (state.holders == 1) return -config_.weight_objectness * problem_.hypotheses[state.holders_sum].objectness;
  return config_.weight_unexplained * state.neighbours;
}

double GlobalCost::flipDelta(int i) const {
  const CostHypothesis& h = problem_.hypotheses[i];
  const int step = active_[i] ? -1 : 1;
  double delta = step * config_.lambda * h.free_space;
  for (const int p : h.inside) {
    PointState state = points_[p];
    const double before = weightOf(state);
    state.holders += step;
    state.holders_sum += step * i;
    delta += problem_.weights[p] * (weightOf(state) - before);
  }
  for (const int p : h.surroundings) {
    if (points_[p].holders == 0) delta += step * config_.weight_unexplained * problem_.weights[p];
  }
  return delta;
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

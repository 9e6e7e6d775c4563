// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/selection/selection_config.hpp"
#include "selection/cost_problem.hpp"

namespace objectness {

/// The cost F(X) of Eq. 8 with the point weights of Eq. 10:
///   F(X) = lambda sum_i free_i x_i + sum_p omega_X(p),
///   omega = weight_multiple kappa          where kappa > 1 active boxes hold p,
///         = - weight_objectness delta(b)   where one does,
///         = weight_unexplained m           where none does and m active boxes have p in their surroundings.
/// Kept up to date under flips: a flip costs the points of its box and surroundings, not the scene.
class GlobalCost {
 public:
  /// The problem must outlive the cost.
  GlobalCost(const CostProblem& problem, const SelectionConfig& config);

  double cost() const { return cost_; }
  const std::vector<bool>& active() const { return active_; }
  int size() const { return static_cast<int>(active_.size()); }

  /// What flipping hypothesis i would add to the cost.
  double flipDelta(int i) const;
  /// Flips hypothesis i; returns what that added.
  double flip(int i);

  /// The cost of a selection from its definition, without any state: what the rest is tested against.
  static double evaluate(const CostProblem& problem, const SelectionConfig& config, const std::vector<bool>& active);

 private:
  /// What is known of a point. holders_sum is the sum of the indices of the active boxes that hold it: with one holder,
  /// its index; sums of integers never drift as sums of scores would.
  struct PointState {
    int holders = 0;
    int neighbours = 0;  ///< active boxes that have it in their surroundings only
    long holders_sum = 0;
  };

  const CostProblem& problem_;
  const SelectionConfig config_;
  std::vector<PointState> points_;
  std::vector<bool> active_;
  double cost_ = 0;
};

}  // namespace objectness

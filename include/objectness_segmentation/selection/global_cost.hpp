// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/selection/cost_problem.hpp"

namespace objectness {

/// Cost and annealing of the global selection, paper Sec. 4.2.
struct SelectionConfig {
  double lambda = 1.0;
  bool free_space_in_voxels = true;
  double weight_multiple = 0.5;
  double weight_objectness = 1.0;
  double weight_unexplained = 1.0;
  double ring_m = 0.04;
  double point_spacing_m = 0.005;
  double start_temperature = 1500;
  double end_temperature = 0.01;
  int iterations = 5000;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("lambda", self.lambda, Range{0, 1000}, "weight of the free space of a selected box, Eq. 8");
    visit("free_space_in_voxels", self.free_space_in_voxels,
          "the free space that lambda weighs is in voxels, as large boxes hold more points too; off: delta_f of Eq. 5");
    visit("weight_multiple", self.weight_multiple, Range{0, 1000}, "case i of Eq. 10: a point in several boxes");
    visit("weight_objectness", self.weight_objectness, Range{0, 1000}, "case ii of Eq. 10: a point in one box");
    visit("weight_unexplained", self.weight_unexplained, Range{0, 1000},
          "case iii of Eq. 10: a point beside a box, in none");
    visit("ring_m", self.ring_m, Range{0, 0.2}, "b_eps of Eq. 10 grows by this on its sides and upwards");
    visit("point_spacing_m", self.point_spacing_m, Range{0.001, 0.1}, "resolution of S', the points that are counted");
    visit("start_temperature", self.start_temperature, Range{0, 1e9}, "annealing: first temperature");
    visit("end_temperature", self.end_temperature, Range{1e-9, 1e9}, "annealing: last temperature");
    visit("iterations", self.iterations, Range{0, 10000000}, "annealing: moves tried");
  }
};

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

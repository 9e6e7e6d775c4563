// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "selection/global_cost.hpp"

namespace objectness {

/// What a flip changes of Eq. 8, in whole points: sums of them do not depend on the order they are counted in.
struct CostChange {
  int step = 1;           ///< 1: the box becomes active, -1: inactive
  long multiple = 0;      ///< change of the sum of kappa over points in several boxes, case i of Eq. 10
  double objectness = 0;  ///< change of the sum of delta(b) over points in one box, by index of the box, case ii
  long unexplained = 0;   ///< change of the sum over points beside boxes, case iii
};

inline double costOf(const CostChange& change, double free_space, const SelectionConfig& config) {
  return change.step * config.lambda * free_space + config.weight_multiple * static_cast<double>(change.multiple) -
         config.weight_objectness * change.objectness +
         config.weight_unexplained * static_cast<double>(change.unexplained);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// Global cost and annealing of paper Sec. 4.2.
struct SelectionConfig {
  double lambda = 0.1;
  double weight_multiple = 0.5;
  double weight_objectness = 1.0;
  double weight_unexplained = 2.0;
  double point_spacing_m = 0.005;
  double start_temperature = 1500;
  double end_temperature = 0.01;
  int iterations = 15000;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("lambda", self.lambda, Range{0, 1000}, "weight of the free space of a selected box, Eq. 8");
    visit("weight_multiple", self.weight_multiple, Range{0, 1000}, "case i of Eq. 10: a point in several boxes");
    visit("weight_objectness", self.weight_objectness, Range{0, 1000}, "case ii of Eq. 10: a point in one box");
    visit("weight_unexplained", self.weight_unexplained, Range{0, 1000}, "case iii of Eq. 10: a point beside a box, in none");
    visit("point_spacing_m", self.point_spacing_m, Range{0.001, 0.1}, "resolution of S', the points that are counted");
    visit("start_temperature", self.start_temperature, Range{0, 1e9}, "annealing: first temperature");
    visit("end_temperature", self.end_temperature, Range{1e-9, 1e9}, "annealing: last temperature");
    visit("iterations", self.iterations, Range{0, 10000000}, "annealing: moves tried");
  }
};

}  // namespace objectness

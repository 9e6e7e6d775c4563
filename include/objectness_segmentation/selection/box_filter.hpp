// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// Filtering of paper Sec. 4.1.
struct FilterConfig {
  double threshold = 0.9;
  double cluster_radius_m = 0.05;
  int max_boxes_per_cluster = 500;
  double conflict_share = 0.95;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("threshold", self.threshold, Range{-10, 10}, "least objectness of a box that is kept");
    visit("cluster_radius_m", self.cluster_radius_m, Range{0.001, 1}, "boxes whose centres lie within it form a cluster");
    visit("max_boxes_per_cluster", self.max_boxes_per_cluster, Range{1, 100000}, "n_b: the best of a cluster that are kept");
    visit("conflict_share", self.conflict_share, Range{0.01, 1},
          "boxes conflict when they share this part of the points of the one with more points");
  }
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// Filtering of paper Sec. 4.1.
struct FilterConfig {
  double threshold = 0.8;
  double cluster_radius_m = 0.05;
  int max_boxes_per_cluster = 500;
  double conflict_share = 0.95;
  bool across_clusters = true;
  double box_margin_m = 0.005;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("threshold", self.threshold, Range{-10, 10}, "least objectness of a box that is kept");
    visit("cluster_radius_m", self.cluster_radius_m, Range{0.001, 1},
          "boxes whose centres lie within it form a cluster");
    visit("max_boxes_per_cluster", self.max_boxes_per_cluster, Range{1, 100000},
          "n_b: the best of a cluster that are kept");
    visit("conflict_share", self.conflict_share, Range{0.01, 1},
          "boxes conflict when they share this part of the points of the one with more points");
    visit("across_clusters", self.across_clusters, "suppress conflicting boxes of different clusters, too");
    visit("box_margin_m", self.box_margin_m, Range{0, 0.05},
          "a point within this of a box counts as inside: faces are sampled coarser than points");
  }
};

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

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// Weights, gates and constants of the objectness measure, paper Eq. 6.
struct ObjectnessConfig {
  double weight_edges = 0.5;
  double weight_outer = 0.5;
  double weight_free = -0.075;
  double constant = 0.5;
  double max_edge_density = 1.0;
  bool three_face_area = false;
  double ring_xy_m = 0.02;
  double ring_z_m = 0.04;
  int min_edge_voxels = 21;
  int min_occupied_voxels = 31;
  double min_top_share = 0.01;
  double min_straddling = 0.5;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("weight_edges", self.weight_edges, Range{-10, 10}, "w_i of Eq. 6: edge density");
    visit("weight_outer", self.weight_outer, Range{-10, 10}, "w_o of Eq. 6: outer edges times superpixel straddling");
    visit("weight_free", self.weight_free, Range{-10, 10}, "w_f of Eq. 6: free space; negative, it is a penalty");
    visit("constant", self.constant, Range{-10, 10}, "added to Eq. 6");
    visit("max_edge_density", self.max_edge_density, Range{0.01, 1000}, "edge density is clipped here");
    visit("three_face_area", self.three_face_area,
          "a(b) is sx sy + sx sz + sy sz whatever the viewpoint, instead of the faces the camera sees");
    visit("ring_xy_m", self.ring_xy_m, Range{0, 0.2}, "b_eps of Eq. 2 grows by this on each of the four sides");
    visit("ring_z_m", self.ring_z_m, Range{0, 0.2}, "b_eps of Eq. 2 grows by this upwards");
    visit("min_edge_voxels", self.min_edge_voxels, Range{1, 10000},
          "gate: boxes with fewer edge voxels are not scored");
    visit("min_occupied_voxels", self.min_occupied_voxels, Range{1, 10000}, "gate: fewer occupied voxels");
    visit("min_top_share", self.min_top_share, Range{0, 1},
          "gate: least share of the occupied voxels in the top third");
    visit("min_straddling", self.min_straddling, Range{0, 1}, "gate: least superpixel cue (Eq. 4)");
  }
};

}  // namespace objectness

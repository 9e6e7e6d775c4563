// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// The sampling of paper Sec. 2.2. Steps and sizes are whole multiples of volume.voxel_m (validate() checks it).
struct SearchConfig {
  double corner_step_m = 0.02;
  double size_step_xy_m = 0.02;
  double size_step_z_m = 0.01;
  double min_size_m = 0.03;
  double max_size_m = 0.45;
  double angle_step_deg = 5.0;
  int max_boxes_per_angle = 200000;
  int top_k = 0;
  double top_k_start = -10;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("corner_step_m", self.corner_step_m, Range{0.002, 0.5}, "step of the box's corner in x and y");
    visit("size_step_xy_m", self.size_step_xy_m, Range{0.002, 0.5}, "step of the box's extent in x and y");
    visit("size_step_z_m", self.size_step_z_m, Range{0.002, 0.5}, "step of the box's height");
    visit("min_size_m", self.min_size_m, Range{0.002, 1.0}, "least extent of a box along each axis");
    visit("max_size_m", self.max_size_m, Range{0.01, 2.0}, "largest extent of a box along each axis");
    visit("angle_step_deg", self.angle_step_deg, Range{1.0, 90.0}, "step of the rotation about the normal, in [0, 90)");
    visit("max_boxes_per_angle", self.max_boxes_per_angle, Range{1, 10000000},
          "of the boxes of an angle that reach the threshold at most this many, the best, are kept");
    visit("top_k", self.top_k, Range{0, 10000000},
          "only this many boxes, the best of all angles, are looked for; 0: all that reach the threshold");
    visit(
        "top_k_start", self.top_k_start, Range{-10, 10},
        "objectness that the top_k boxes are expected to reach, as in the frame before: quicker, and the same result, "
        "as the search begins anew when they do not");
  }
};

}  // namespace objectness

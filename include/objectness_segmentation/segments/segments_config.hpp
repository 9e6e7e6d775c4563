// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

struct SegmentsConfig {
  double min_superpixel_share = 0.5;
  double max_reach_m = 0.04;
  double max_step_m = 0.015;
  int min_pixels = 100;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("min_superpixel_share", self.min_superpixel_share, Range{0, 1},
          "paper's boxes: a superpixel follows a box that holds at least this share of it");
    visit("max_reach_m", self.max_reach_m, Range{0, 0.5},
          "paper's boxes: how far along the surface a point follows its nearest segment");
    visit("max_step_m", self.max_step_m, Range{0.001, 0.1},
          "paper's boxes: neighbouring pixels farther apart are not on one surface");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "smaller segments are dropped");
  }
};

struct BackgroundConfig {
  bool judged = true;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("judged", self.judged,
          "what leaves the picture and lies beside the table, or flat on it, is no object; off: it is published, too");
  }
};

}  // namespace objectness

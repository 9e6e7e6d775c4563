// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

struct SegmentsConfig {
  bool follow_superpixels = true;
  double max_reach_m = 0.04;
  int min_pixels = 100;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("follow_superpixels", self.follow_superpixels,
          "whole superpixels follow the box that holds most of them, other points their nearest segment; "
          "off: the pixels of the paper's plain boxes");
    visit("max_reach_m", self.max_reach_m, Range{0, 0.5}, "how far along the surface a point follows its nearest segment");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "smaller segments are dropped");
  }
};

}  // namespace objectness

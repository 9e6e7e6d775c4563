// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

struct ResolutionConfig {
  double finest_pixel_m = 0.0008;
  int min_width_px = 600;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(
        "finest_pixel_m", self.finest_pixel_m, Range{0, 0.01},
        "pixels that are finer than this on what is seen are averaged, up to twice this; results are the input's size; "
        "0: never");
    visit("min_width_px", self.min_width_px, Range{100, 100000}, "but never to a picture narrower than this");
  }
};

}  // namespace objectness

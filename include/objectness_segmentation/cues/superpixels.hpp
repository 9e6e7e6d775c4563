// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// Smooth over-segmentation of the object points (paper Sec. 3.3).
struct Superpixels {
  cv::Mat_<int> label;  ///< H x W; 0 = not smooth or not an object point, 1..count = superpixel
  int count = 0;
};

struct SuperpixelsConfig {
  double min_area_m2 = 0.75e-4;
  int min_pixels = 40;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("min_area_m2", self.min_area_m2, Range{0, 0.01}, "smaller pieces get label 0");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "pieces of fewer pixels get label 0");
  }
};

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config);

}  // namespace objectness

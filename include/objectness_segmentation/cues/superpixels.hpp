// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// Smooth over-segmentation of the object points (paper Sec. 3.3).
struct Superpixels {
  cv::Mat_<int> label;  ///< H x W; 0 = not smooth or not an object point, 1..count = superpixel, by its first pixel
  int count = 0;
};

struct SuperpixelsConfig {
  double concave_deg = 30.0;
  double convex_deg = 70.0;
  double neighbor_deg = 8.0;
  double max_residuals = 5.0;
  double max_steps = 4.0;
  double min_step_m = 0.002;
  double narrow_share = 0.4;
  double min_area_m2 = 0.75e-4;
  int min_pixels = 40;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("concave_deg", self.concave_deg, Range{0, 180},
          "cut where the normals one window radius to either side bend more towards each other: things that touch");
    visit("convex_deg", self.convex_deg, Range{0, 180}, "cut where they bend more away from each other: edges");
    visit("neighbor_deg", self.neighbor_deg, Range{0, 180}, "cut where normals of neighbouring pixels differ by more");
    visit("max_residuals", self.max_residuals, Range{0, 1000},
          "cut where the plane fits worse than this many times the table's own median residual at that depth");
    visit("max_steps", self.max_steps, Range{0, 1000},
          "not for the paper's boxes: cut where the surface steps to the side by more than this many times the table's "
          "own "
          "median step");
    visit("min_step_m", self.min_step_m, Range{0, 1}, "and by more than this");
    visit("narrow_share", self.narrow_share, Range{0, 1},
          "not for the paper's boxes: cut where the surface is narrower than this share of what it joins");
    visit("min_area_m2", self.min_area_m2, Range{0, 0.01}, "smaller pieces get label 0");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "pieces of fewer pixels get label 0");
  }
};

/// For the paper's boxes: no cuts at steps and narrow places. These cuts help grouping, which joins superpixels again,
/// but they remove whole faces from a box.
SuperpixelsConfig superpixelsForBoxes(SuperpixelsConfig config);

/// Grows pieces of smooth surface over the pixels of object_points.mask. Bends are metric and signed: a concave one
/// separates things that touch, so it cuts early; a convex one is mostly an edge within one thing.
Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config, int threads = 1);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// The scene points S' above the table (paper Sec. 2): what boxes are searched around and segments are cut from.
struct ObjectPoints {
  cv::Mat_<float> height_m;  ///< H x W signed height over the table plane, NaN = invalid point
  cv::Mat_<uchar> mask;      ///< H x W, 255 = a point that stands on the table, 0 = anything else
  cv::Mat_<uchar> on_table;  ///< H x W, 255 = a point of the table's own surface, inside its hull
};

struct ObjectPointsConfig {
  double max_height_m = 0.45;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("max_height_m", self.max_height_m, Range{0.03, 2.0}, "things that reach over this height are not objects");
  }
};

/// Which points stand on the table. Deterministic; an empty mask (nothing on the table) is a valid result.
ObjectPoints findObjectPoints(const Frame& frame, const Normals& normals, const Table& table,
                              const ObjectPointsConfig& config);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// The scene points S' above the table (paper Sec. 2): what boxes are searched around and segments are cut from.
struct ObjectPoints {
  cv::Mat_<float> height_m;  ///< H x W signed height over the table plane, NaN = invalid point
  cv::Mat_<uchar> mask;      ///< H x W, 255 = a point that stands on the table, 0 = anything else
  /// H x W, 255 = a point of a surface that carries objects: the table's own, inside its extent, or the floor of a
  /// tray, tote or bin.
  cv::Mat_<uchar> on_table;
  cv::Mat_<uchar> container;  ///< H x W, 255 = a point of a tray, tote or bin with things in it: its floor or its walls
};

struct ObjectPointsConfig {
  double noise_sigmas = 3.5;
  double min_threshold_m = 0.003;
  double max_threshold_m = 0.015;
  double max_height_m = 0.45;
  double min_area_m2 = 3e-4;
  double min_inside_share = 0.35;
  bool hollow_floors = true;
  bool containers = true;
  bool low_things = true;
  double low_sigmas = 4.0;
  double low_min_height_m = 0.006;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("noise_sigmas", self.noise_sigmas, Range{0.5, 20},
          "a point counts from this many sigma of depth noise over the table");
    visit("min_threshold_m", self.min_threshold_m, Range{0, 0.1}, "but never from less height than this");
    visit("max_threshold_m", self.max_threshold_m, Range{0, 0.1}, "and always from more height than this");
    visit("max_height_m", self.max_height_m, Range{0.03, 2.0},
          "things that reach over this height are not objects, but for stacks of up to twice the height that stand "
          "alone: not from beside the table or out of the picture");
    visit("min_area_m2", self.min_area_m2, Range{0, 0.1},
          "things that show less surface (seen head-on) are not objects");
    visit("min_inside_share", self.min_inside_share, Range{0, 1},
          "least share of a thing's points over the table's extent");
    visit("hollow_floors", self.hollow_floors,
          "points at table height enclosed by one hollow thing (a bowl) belong to it");
    visit("containers", self.containers,
          "trays, totes and bins that things are in carry these as the table does, and are no objects themselves");
    visit("low_things", self.low_things,
          "points within the noise over the table count where a whole patch of them agrees");
    visit("low_sigmas", self.low_sigmas, Range{1, 20},
          "a patch counts from this many sigma of the noise that patches of the table have");
    visit("low_min_height_m", self.low_min_height_m, Range{0, 0.1}, "but never from less mean height than this");
  }
};

/// Which points stand on the table. Deterministic; an empty mask (nothing on the table) is a valid result.
ObjectPoints findObjectPoints(const Frame& frame, const Normals& normals, const Table& table,
                              const ObjectPointsConfig& config, int threads = 1);

}  // namespace objectness

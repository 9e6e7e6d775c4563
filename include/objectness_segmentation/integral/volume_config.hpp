// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// The volume of interest and its voxels, paper Sec. 2 and 2.3.
struct VolumeConfig {
  double voxel_m = 0.01;
  double min_extent_m = 0.0;
  double min_height_m = 0.0;
  bool unknown_is_occluded = false;
  double occlusion_tolerance_m = 0.01;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("voxel_m", self.voxel_m, Range{0.002, 0.05}, "side of a voxel of the integral volumes");
    visit("min_extent_m", self.min_extent_m, Range{0, 5},
          "least extent of the volume of interest in x and y; 0: as far as the object points reach");
    visit("min_height_m", self.min_height_m, Range{0, 2},
          "least height of the volume of interest, up to search.max_size_m; 0: as high as the object points");
    visit("unknown_is_occluded", self.unknown_is_occluded,
          "voxels behind pixels without depth: occluded instead of free");
    visit("occlusion_tolerance_m", self.occlusion_tolerance_m, Range{0, 0.1},
          "a voxel is occluded when it lies deeper than the measured depth by more than this");
  }
};

}  // namespace objectness

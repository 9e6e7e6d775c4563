// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "integral/grid.hpp"
#include "objectness_segmentation/search/search_config.hpp"

namespace objectness {

/// SearchConfig in voxels.
struct Sampling {
  int corner_step = 2;
  int size_step_xy = 2, size_step_z = 1;
  int min_size = 3, max_size = 45;
};
Sampling samplingOf(const SearchConfig& config, double voxel_m);

/// The angles r_z, radians: multiples of the step in [0, 90) degrees.
std::vector<double> sampledAngles(const SearchConfig& config);

/// How many boxes of the sampling fit into the grid of one angle.
std::int64_t countBoxes(const Grid& grid, const Sampling& sampling);

}  // namespace objectness

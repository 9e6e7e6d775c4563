// SPDX-License-Identifier: BSD-3-Clause
#include "search/box_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"

namespace objectness {
namespace {

/// (corner, size) pairs along one horizontal axis.
std::int64_t countPairs(int extent, const Sampling& s) {
  std::int64_t pairs = 0;
  for (int corner = 0; corner + s.min_size <= extent; corner += s.corner_step) {
    pairs += (std::min(s.max_size, extent - corner) - s.min_size) / s.size_step_xy + 1;
  }
  return pairs;
}

}  // namespace

Sampling samplingOf(const SearchConfig& config, double voxel_m) {
  const auto voxels = [&](double metres) { return static_cast<int>(std::lround(metres / voxel_m)); };
  return {voxels(config.corner_step_m), voxels(config.size_step_xy_m), voxels(config.size_step_z_m),
          voxels(config.min_size_m), voxels(config.max_size_m)};
}

std::vector<double> sampledAngles(const SearchConfig& config) {
  std::vector<double> angles;
  // The slack keeps a step like 90 / 7 from sampling 90 degrees itself, which is 0 degrees again.
  for (int k = 0; k * config.angle_step_deg < 90.0 - 1e-9; ++k) angles.push_back(k * config.angle_step_deg * kDegree);
  return angles;
}

std::int64_t countBoxes(const Grid& grid, const Sampling& s) {
  const int tallest = std::min(s.max_size, grid.nz);
  if (tallest < s.min_size) return 0;
  const std::int64_t heights = (tallest - s.min_size) / s.size_step_z + 1;
  return countPairs(grid.nx, s) * countPairs(grid.ny, s) * heights;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/scene_points.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace objectness {

std::vector<Eigen::Vector3f> thinPoints(const std::vector<Eigen::Vector3f>& points, double spacing_m, double top_m) {
  std::vector<Eigen::Vector3f> thinned;
  std::unordered_set<std::uint64_t> seen;
  for (const auto& p : points) {
    if (p.z() > top_m) continue;
    std::uint64_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // 21 bits an axis: 10 km at 5 mm.
      const auto index = static_cast<std::int64_t>(std::floor(p[axis] / spacing_m)) + (1 << 20);
      cell = cell << 21 | (static_cast<std::uint64_t>(index) & 0x1FFFFF);
    }
    if (seen.insert(cell).second) thinned.push_back(p);
  }
  return thinned;
}

}  // namespace objectness

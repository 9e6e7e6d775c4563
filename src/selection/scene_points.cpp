// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/scene_points.hpp"

#include <cstdint>
#include <unordered_set>

#include "objectness_segmentation/selection/cell_key.hpp"

namespace objectness {

std::vector<Eigen::Vector3f> thinPoints(const std::vector<Eigen::Vector3f>& points, double spacing_m, double top_m) {
  std::vector<Eigen::Vector3f> thinned;
  std::unordered_set<std::uint64_t> seen;
  for (const auto& p : points) {
    if (p.z() > top_m) continue;
    if (seen.insert(keyOf(cellOf(p, spacing_m))).second) thinned.push_back(p);
  }
  return thinned;
}

}  // namespace objectness

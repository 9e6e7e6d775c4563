// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/object_points.hpp"

#include <cmath>

#include "height_map.hpp"
#include "objectness_segmentation/common/row_bands.hpp"
#include "standing_things.hpp"
#include "wall_patches.hpp"

namespace objectness {
namespace {

constexpr float kMinTableCosine = 0.866f;  // 30 deg; the side of a thing's foot is not table

cv::Mat_<uchar> tableSurface(const Normals& normals, const Table& table, const HeightMap& map,
                             const cv::Mat_<uchar>& mask, int threads) {
  const Eigen::Vector3f up = table.normal.cast<float>();
  cv::Mat_<uchar> surface(mask.size());
  forRowBands(mask.rows, threads, [&](int first, int last) {
    for (int v = first; v < last; ++v) {
      const float *height = map.height_m[v], *threshold = map.threshold_m[v];
      const uchar *object = mask[v], *inside = map.inside[v];
      const uchar* radius = normals.radius_px.data() + std::size_t(v) * mask.cols;
      const Eigen::Vector3f* normal = normals.normal.data() + std::size_t(v) * mask.cols;
      for (int u = 0; u < mask.cols; ++u) {
        const bool level = !object[u] && inside[u] && std::abs(height[u]) <= threshold[u];
        surface(v, u) = level && !(radius[u] > 0 && normal[u].dot(up) < kMinTableCosine) ? 255 : 0;
      }
    }
  });
  return surface;
}

}  // namespace

ObjectPoints findObjectPoints(const Frame& frame, const Normals& normals, const Table& table,
                              const ObjectPointsConfig& config, int threads) {
  const HeightMap map = makeHeightMap(frame, table, config, threads);
  cv::Mat_<uchar> mask = aboveTable(map);
  removeWalls(frame, normals, table, map, config, mask, threads);
  const Things things = findThings(frame, table, map, config, mask, threads);
  mask = things.label > 0;
  cv::Mat_<uchar> with_floors = mask.clone(), surface;
  inParallel(
      threads,
      [&] {
        if (config.hollow_floors) addHollowFloors(frame, table, map, things, with_floors);
      },
      [&] { surface = tableSurface(normals, table, map, mask, threads); });
  surface.setTo(0, with_floors);
  return {map.height_m, with_floors, surface};
}

}  // namespace objectness

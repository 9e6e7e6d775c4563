// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/object_points.hpp"

#include <cmath>

#include "common/parallel.hpp"
#include "scene/containers.hpp"
#include "scene/height_map.hpp"
#include "scene/hollow_floors.hpp"
#include "scene/low_things.hpp"
#include "scene/table_clusters.hpp"
#include "scene/wall_patches.hpp"

namespace objectness {
namespace {

constexpr float kMinTableCosine = 0.866f;  // 30 deg; the side of a thing's foot is not table
constexpr int kBands = 8;                  // of the picture

/// Rows first..last-1 of ObjectPoints::on_table, before the floors of hollow things are taken off.
void markTableSurface(const Normals& normals, const Eigen::Vector3f& up, const HeightMap& map,
                      const cv::Mat_<uchar>& mask, int first, int last, cv::Mat_<uchar>& surface) {
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
}

}  // namespace

ObjectPoints findObjectPoints(const Frame& frame, const Normals& normals, const Table& table,
                              const ObjectPointsConfig& config, int threads) {
  HeightMap map = makeHeightMap(frame, table, config, threads);
  cv::Mat_<uchar> mask = aboveTable(map);
  if (config.low_things) mask |= lowThings(map, config, mask, threads);
  const ContainerMasks containers = takeContainers(
      frame, normals, table,
      config.containers ? findContainers(frame, normals, table, map, mask) : std::vector<Container>{}, map, mask);
  removeWalls(frame, normals, table, map, config, mask, threads);
  const TableClusters clusters = findTableClusters(frame, table, map, config, mask, threads);
  mask = clusters.label > 0;
  cv::Mat_<uchar> with_floors = mask.clone(), surface(mask.size());
  const Eigen::Vector3f up = table.normal.cast<float>();
  // One thread looks for floors; whoever has time meanwhile marks the table, band by band.
  parallelFor(1 + kBands, threads, [&](int i) {
    if (i > 0) {
      markTableSurface(normals, up, map, mask, mask.rows * (i - 1) / kBands, mask.rows * i / kBands, surface);
    } else if (config.hollow_floors) {
      addHollowFloors(frame, table, map, clusters, with_floors);
    }
  });
  surface |= containers.floor;
  surface.setTo(0, with_floors);
  return {map.height_m, with_floors, surface, containers.all};
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/object_points.hpp"

#include <cmath>

#include "height_map.hpp"
#include "standing_things.hpp"
#include "wall_patches.hpp"

namespace objectness {
namespace {

constexpr float kMinTableCosine = 0.866f;  // 30 deg; the side of a thing's foot is not table

cv::Mat_<uchar> tableSurface(const Normals& normals, const Table& table, const HeightMap& map,
                             const cv::Mat_<uchar>& mask) {
  const Eigen::Vector3f up = table.normal.cast<float>();
  cv::Mat_<uchar> surface(mask.size(), uchar(0));
  for (int v = 0, i = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u, ++i) {
      if (mask(v, u) || !map.inside(v, u) || !(std::abs(map.height_m(v, u)) <= map.threshold_m(v, u))) continue;
      if (normals.radius_px[i] > 0 && normals.normal[i].dot(up) < kMinTableCosine) continue;
      surface(v, u) = 255;
    }
  }
  return surface;
}

}  // namespace

ObjectPoints findObjectPoints(const Frame& frame, const Normals& normals, const Table& table,
                              const ObjectPointsConfig& config) {
  const HeightMap map = makeHeightMap(frame, table, config);
  cv::Mat_<uchar> mask = aboveTable(map);
  removeWalls(frame, normals, table, map, config, mask);
  const Things things = findThings(frame, table, map, config, mask);
  mask = things.label > 0;
  if (config.hollow_floors) addHollowFloors(frame, table, map, things, mask);
  return {map.height_m, mask, tableSurface(normals, table, map, mask)};
}

}  // namespace objectness

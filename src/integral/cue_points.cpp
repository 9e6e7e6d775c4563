// SPDX-License-Identifier: BSD-3-Clause
#include "integral/cue_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace objectness {

CuePoints collectCuePoints(const Frame& frame, const Table& table, const ObjectPoints& object_points,
                           const EdgeMap& edges, const Superpixels& superpixels) {
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  CuePoints cues;
  cues.superpixels = superpixels.count;
  for (int v = 0, pixel = 0; v < frame.height(); ++v) {
    for (int u = 0; u < frame.width(); ++u, ++pixel) {
      const bool is_object = object_points.mask(v, u) != 0, is_edge = edges.kinds(v, u) != 0;
      if (!is_object && !is_edge) continue;
      Eigen::Vector3f p = T_table_camera * frame.points[pixel];
      if (!p.allFinite()) continue;
      // Floors of hollow things lie at table height, noise included: they stand on the table all the same.
      p.z() = std::max(p.z(), 0.0f);
      if (is_edge) cues.edges.push_back(p);
      if (!is_object) continue;
      cues.points.push_back(p);
      cues.pixels.push_back(pixel);
      cues.labels.push_back(superpixels.label(v, u));
      cues.top_m = std::max(cues.top_m, p.z());
    }
  }
  return cues;
}

Grid makeGrid(const CuePoints& points, double angle_rad, const VolumeConfig& config, int margin, int min_height,
              int max_height) {
  const float c = static_cast<float>(std::cos(angle_rad)), s = static_cast<float>(std::sin(angle_rad));
  constexpr float kFar = std::numeric_limits<float>::max();
  Eigen::Vector2f low(kFar, kFar), high(-kFar, -kFar);
  for (const auto& p : points.points) {
    const Eigen::Vector2f q(c * p.x() + s * p.y(), -s * p.x() + c * p.y());
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  if (points.points.empty()) low = high = Eigen::Vector2f::Zero();
  return makeGrid(low, high, points.top_m, angle_rad, config, margin, min_height, max_height);
}

Grid makeGrid(const Eigen::Vector2f& low, const Eigen::Vector2f& high, float top_m, double angle_rad,
              const VolumeConfig& config, int margin, int min_height, int max_height) {
  Grid grid;
  grid.angle_rad = angle_rad;
  grid.cosine = std::cos(angle_rad);
  grid.sine = std::sin(angle_rad);
  grid.voxel_m = config.voxel_m;
  int size[2];
  for (int axis = 0; axis < 2; ++axis) {
    // Snapped to multiples of a voxel, so that the grid does not slide with every point of noise.
    long first = std::lround(std::floor(low[axis] / config.voxel_m)),
         last = std::lround(std::floor(high[axis] / config.voxel_m));
    const long missing = std::lround(std::ceil(config.min_extent_m / config.voxel_m)) - (last - first + 1);
    if (missing > 0) {
      first -= missing / 2;
      last += missing - missing / 2;
    }
    grid.origin_m[axis] = (first - margin) * config.voxel_m;
    size[axis] = static_cast<int>(last - first + 1 + 2 * margin);
  }
  grid.nx = size[0];
  grid.ny = size[1];
  const int least = std::max(min_height, static_cast<int>(std::lround(config.min_height_m / config.voxel_m)));
  grid.nz = std::min(std::max(static_cast<int>(std::floor(top_m / config.voxel_m)) + 1, least), max_height);
  return grid;
}

}  // namespace objectness

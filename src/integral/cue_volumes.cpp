// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/integral/cue_volumes.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

/// The voxel that holds a point, or (-1, ., .) when it lies outside the grid.
Eigen::Vector3i voxelOf(const Grid& grid, const Eigen::Vector3f& p_table) {
  const Eigen::Vector3d q = grid.toGrid(p_table.cast<double>());
  const Eigen::Vector3i voxel(static_cast<int>(std::floor(q.x())), static_cast<int>(std::floor(q.y())),
                              static_cast<int>(std::floor(q.z())));
  const bool inside = voxel.x() >= 0 && voxel.x() < grid.nx && voxel.y() >= 0 && voxel.y() < grid.ny &&
                      voxel.z() >= 0 && voxel.z() < grid.nz;
  return inside ? voxel : Eigen::Vector3i(-1, -1, -1);
}

/// Every voxel centre is looked up in the depth image itself: rotating a volume made for another angle leaves holes.
void markFilled(const Frame& frame, const Table& table, const VolumeConfig& config, const Grid& grid,
                const IntegralVolume& occupied, IntegralVolume& filled) {
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  const Eigen::Vector3d step_z = T_camera_table.linear() * Eigen::Vector3d(0, 0, grid.voxel_m);
  for (int x = 0; x < grid.nx; ++x) {
    for (int y = 0; y < grid.ny; ++y) {
      const Eigen::Vector3d base = T_camera_table * grid.toTable({x + 0.5, y + 0.5, 0.5});
      for (int z = 0; z < grid.nz; ++z) {
        if (occupied.isSet(x, y, z) || isOccluded(frame, base + z * step_z, config)) filled.set(x, y, z);
      }
    }
  }
}

}  // namespace

SuperpixelVolume::SuperpixelVolume(const std::vector<Eigen::Vector3i>& voxels) {
  if (voxels.empty()) return;
  Eigen::Vector3i high = voxels.front();
  low_ = voxels.front();
  for (const auto& voxel : voxels) {
    low_ = low_.cwiseMin(voxel);
    high = high.cwiseMax(voxel);
  }
  const Eigen::Vector3i size = high - low_ + Eigen::Vector3i::Ones();
  volume_ = IntegralVolume(size.x(), size.y(), size.z());
  for (const auto& voxel : voxels) volume_.set(voxel.x() - low_.x(), voxel.y() - low_.y(), voxel.z() - low_.z());
  volume_.integrate();
}

bool isOccluded(const Frame& frame, const Eigen::Vector3d& p_camera, const VolumeConfig& config) {
  if (p_camera.z() <= 0) return false;
  const Eigen::Vector2d pixel = frame.camera.project(p_camera);
  const double u = std::floor(pixel.x() + 0.5), v = std::floor(pixel.y() + 0.5);
  if (!(u >= 0 && v >= 0 && u < frame.width() && v < frame.height())) return false;
  const float depth = frame.points[static_cast<std::size_t>(v) * frame.width() + static_cast<std::size_t>(u)].z();
  if (std::isnan(depth)) return config.unknown_is_occluded;
  return p_camera.z() > depth + config.occlusion_tolerance_m;
}

CueVolumes buildCueVolumes(const Frame& frame, const Table& table, const CuePoints& points, const Grid& grid,
                           const VolumeConfig& config, int ring_z) {
  CueVolumes volumes;
  volumes.grid = grid;
  volumes.viewpoint = grid.toGrid(table.T_table_camera.translation());
  volumes.edges = IntegralVolume(grid.nx, grid.ny, grid.nz, ring_z);
  for (const auto& p : points.edges) {
    const Eigen::Vector3i voxel = voxelOf(grid, p);
    if (voxel.x() >= 0) volumes.edges.set(voxel.x(), voxel.y(), voxel.z());
  }
  volumes.occupied = IntegralVolume(grid.nx, grid.ny, grid.nz);
  std::vector<std::vector<Eigen::Vector3i>> voxels_of(points.superpixels + 1);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Eigen::Vector3i voxel = voxelOf(grid, points.points[i]);
    if (voxel.x() < 0) continue;
    volumes.occupied.set(voxel.x(), voxel.y(), voxel.z());
    if (points.labels[i] > 0) voxels_of[points.labels[i]].push_back(voxel);
  }
  for (const auto& voxels : voxels_of) {
    if (!voxels.empty()) volumes.superpixels.emplace_back(voxels);
  }
  volumes.filled = IntegralVolume(grid.nx, grid.ny, grid.nz);
  markFilled(frame, table, config, grid, volumes.occupied, volumes.filled);
  volumes.edges.integrate();
  volumes.occupied.integrate();
  volumes.filled.integrate();
  return volumes;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "reference/plain_voxels.hpp"

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
                const VoxelBits& occupied, VoxelBits& filled) {
  const VoxelCentres centres(grid, table.T_table_camera);
  for (int x = 0; x < grid.nx; ++x) {
    for (int y = 0; y < grid.ny; ++y) {
      const Eigen::Vector3d lowest = centres.lowest(x, y);
      for (int z = 0; z < grid.nz; ++z) {
        if (occupied.isSet(x, y, z) || isOccluded(frame, lowest + z * centres.stepUp(), config)) filled.set(x, y, z);
      }
    }
  }
}

}  // namespace

CueVoxels markVoxelsPlain(const Frame& frame, const Table& table, const CuePoints& points, const Grid& grid,
                          const VolumeConfig& config) {
  CueVoxels marked;
  marked.grid = grid;
  marked.edges.reset(grid.nx, grid.ny, grid.nz);
  marked.occupied.reset(grid.nx, grid.ny, grid.nz);
  marked.filled.reset(grid.nx, grid.ny, grid.nz);
  for (const auto& p : points.edges) {
    const Eigen::Vector3i voxel = voxelOf(grid, p);
    if (voxel.x() >= 0) marked.edges.set(voxel.x(), voxel.y(), voxel.z());
  }
  std::vector<std::vector<Eigen::Vector3i>> voxels_of(points.superpixels + 1);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Eigen::Vector3i voxel = voxelOf(grid, points.points[i]);
    if (voxel.x() < 0) continue;
    marked.occupied.set(voxel.x(), voxel.y(), voxel.z());
    if (points.labels[i] > 0) voxels_of[points.labels[i]].push_back(voxel);
  }
  for (const auto& voxels : voxels_of) {
    if (!voxels.empty()) marked.superpixels.push_back(superpixelVoxels(voxels, grid.nz));
  }
  markFilled(frame, table, config, grid, marked.occupied, marked.filled);
  return marked;
}

}  // namespace objectness

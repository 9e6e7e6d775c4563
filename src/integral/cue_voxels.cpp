// SPDX-License-Identifier: BSD-3-Clause
#include "integral/cue_voxels.hpp"

#include <cmath>

namespace objectness {

SuperpixelVoxels superpixelVoxels(const std::vector<Eigen::Vector3i>& voxels, int nz) {
  Eigen::Vector3i low = voxels.front(), high = voxels.front();
  for (const auto& voxel : voxels) {
    low = low.cwiseMin(voxel);
    high = high.cwiseMax(voxel);
  }
  SuperpixelVoxels superpixel{low.x(), low.y(), VoxelBits(high.x() - low.x() + 1, high.y() - low.y() + 1, nz)};
  for (const auto& voxel : voxels) superpixel.voxels.set(voxel.x() - low.x(), voxel.y() - low.y(), voxel.z());
  return superpixel;
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

}  // namespace objectness

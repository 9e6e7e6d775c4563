// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "objectness_segmentation/integral/cue_points.hpp"
#include "objectness_segmentation/integral/grid.hpp"
#include "objectness_segmentation/integral/integral_volume.hpp"

namespace objectness {

/// The integral volume of one superpixel on its own bounding box: most boxes meet few superpixels, and a table over the
/// whole grid for each would cost memory for nothing.
class SuperpixelVolume {
 public:
  SuperpixelVolume(const std::vector<Eigen::Vector3i>& voxels);

  /// Voxels of the superpixel in the box (any box of the grid).
  int count(int x0, int x1, int y0, int y1, int height) const {
    x0 = std::max(x0 - low_.x(), 0), x1 = std::min(x1 - low_.x(), volume_.nx());
    y0 = std::max(y0 - low_.y(), 0), y1 = std::min(y1 - low_.y(), volume_.ny());
    height = std::min(height - low_.z(), volume_.nz());
    return x0 < x1 && y0 < y1 && height > 0 ? volume_.count(x0, x1, y0, y1, height) : 0;
  }
  int total() const { return volume_.total(); }

 private:
  Eigen::Vector3i low_ = Eigen::Vector3i::Zero();
  IntegralVolume volume_;
};

/// All integral volumes of one angle. Everything is counted in voxels: it makes near and far objects alike, and it is
/// the only unit in which Eq. 5 subtracts points from a volume.
struct CueVolumes {
  Grid grid;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< the camera's centre, grid coordinates (voxels)
  IntegralVolume edges;                                 ///< an edge point of any kind inside, Sec. 3.1
  IntegralVolume occupied;                              ///< V: a point inside, Sec. 2.3
  IntegralVolume filled;                                ///< V or V_O: occupied or occluded
  std::vector<SuperpixelVolume> superpixels;            ///< one per label that has a voxel in the grid, Sec. 3.3
};

/// Builds the volumes of one angle. ring_z: how far over the grid boxes may reach (b_eps of Eq. 2), voxels.
CueVolumes buildCueVolumes(const Frame& frame, const Table& table, const CuePoints& points, const Grid& grid,
                           const VolumeConfig& config, int ring_z);

/// Whether the point is hidden from the camera: its pixel was measured nearer than it by more than the tolerance
/// (Sec. 2.3). Beyond the image: free. Missing depth: unknown_is_occluded.
bool isOccluded(const Frame& frame, const Eigen::Vector3d& p_camera, const VolumeConfig& config);

}  // namespace objectness

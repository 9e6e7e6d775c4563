// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "integral/cue_points.hpp"
#include "integral/grid.hpp"
#include "integral/voxel_bits.hpp"

namespace objectness {

/// The voxels of one superpixel, on its own bounding box in x and y: most boxes meet few superpixels, and a volume over
/// the whole grid for each would cost memory for nothing.
struct SuperpixelVoxels {
  int x0 = 0, y0 = 0;  ///< the grid's voxel that is (0, 0) here
  VoxelBits voxels;    ///< as high as the grid
};

/// What each voxel of one angle's grid holds, paper Sec. 2.3, 3.1 and 3.3.
struct CueVoxels {
  Grid grid;
  VoxelBits edges;                            ///< an edge point of any kind
  VoxelBits occupied;                         ///< V: an object point
  VoxelBits filled;                           ///< V or V_O: occupied or occluded
  std::vector<SuperpixelVoxels> superpixels;  ///< those with a voxel in the grid, by label
};

/// One superpixel's voxels (grid coordinates, not empty) in a grid `nz` high.
SuperpixelVoxels superpixelVoxels(const std::vector<Eigen::Vector3i>& voxels, int nz);

/// Whether the point is hidden from the camera: its pixel was measured nearer than it by more than the tolerance
/// (Sec. 2.3). Beyond the image: free. Missing depth: unknown_is_occluded.
bool isOccluded(const Frame& frame, const Eigen::Vector3d& p_camera, const VolumeConfig& config);

/// The voxel centres of a grid in the camera's frame, metres.
class VoxelCentres {
 public:
  VoxelCentres(const Grid& grid, const Eigen::Isometry3d& T_table_camera)
      : grid_(grid),
        T_camera_table_(T_table_camera.inverse()),
        step_z_(T_camera_table_.linear() * Eigen::Vector3d(0, 0, grid.voxel_m)) {}

  /// Of column (x, y): the lowest, and what the next one is farther by.
  Eigen::Vector3d lowest(int x, int y) const { return T_camera_table_ * grid_.toTable({x + 0.5, y + 0.5, 0.5}); }
  const Eigen::Vector3d& stepUp() const { return step_z_; }

 private:
  const Grid& grid_;
  Eigen::Isometry3d T_camera_table_;
  Eigen::Vector3d step_z_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "integral/cue_voxels.hpp"

namespace objectness {

class OcclusionMap;

/// Marks the voxels of a frame at any angle, the same as one by one (test/reference/plain_voxels.hpp): everything that
/// does not depend on the angle is done once.
class Voxelizer {
 public:
  Voxelizer(const CuePoints& points, const VolumeConfig& config);
  ~Voxelizer();

  /// makeGrid() of the points.
  Grid gridAt(double angle_rad, int margin, int min_height, int max_height) const;

  /// Sorts the points and classifies what the frame hides, for these grids (all of the same height). Before mark().
  void prepare(const Frame& frame, const Table& table, const std::vector<Grid>& grids, int threads);

  /// Memory that mark() works in, one for each thread.
  struct Scratch {
    std::vector<std::int32_t> x, y;
  };
  /// The voxels of one of the grids; the memory of `voxels` is kept.
  void mark(const Grid& grid, Scratch& scratch, CueVoxels& voxels) const;

 private:
  /// Points with their height in voxels.
  struct Columns {
    std::vector<float> x, y;
    std::vector<std::int32_t> z;
    void add(const Eigen::Vector3f& p, double voxel_m, int nz);
  };
  void markSuperpixels(const Scratch& scratch, int nz, std::vector<SuperpixelVoxels>& superpixels) const;
  void markHidden(const Grid& grid, const VoxelBits& occupied, VoxelBits& filled) const;

  const CuePoints& points_;
  const VolumeConfig config_;
  std::vector<float> all_x_, all_y_;  ///< of all points, in their order
  Columns object_, edge_;             ///< object points by label
  std::vector<int> first_of_;         ///< label s: object points first_of_[s] .. first_of_[s + 1] - 1
  Eigen::Isometry3d T_table_camera_ = Eigen::Isometry3d::Identity();
  std::unique_ptr<OcclusionMap> occlusion_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "integral/voxel_kernel.hpp"
#include "objectness_segmentation/integral/volume_config.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// A rectangle on the table, metres, table frame.
struct TableRegion {
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero(), high_m = Eigen::Vector2d::Zero();
};

/// What a frame hides, classified once for all box angles: the space over a region of the table is cut into cells of
/// two by two voxels, eight high, and each told to be clear, hidden or to be looked at voxel by voxel. The classes are
/// safe: a voxel whose centre lies in a clear (hidden) cell is clear (hidden) by isOccluded().
class OcclusionMap {
 public:
  OcclusionMap(const Frame& frame, const Table& table, const VolumeConfig& config, const TableRegion& region, int nz,
               int threads);

  /// Bit g: voxels 8 g .. 8 g + 7 of a column.
  struct Groups {
    std::uint64_t hidden = 0, mixed = ~std::uint64_t{0};
  };
  /// Of the column whose centre is there (table frame, metres).
  Groups at(double x_m, double y_m) const;

  const TransposedDepth& view() const { return view_; }

 private:
  void copyDepth(const Frame& frame, bool unknown_is_occluded, int threads);
  void classify(const Table& table, double voxel_m, int nz, int threads);
  /// Least and largest depth in the pixels u0..u1, v0..v1 at least.
  std::pair<float, float> depthRange(int u0, int u1, int v0, int v1) const;

  TableRegion region_;
  double cell_m_;
  int cells_x_, cells_y_;
  std::vector<float> depth_;
  std::vector<float> block_low_, block_high_;
  int blocks_v_;
  std::vector<Groups> cells_;
  TransposedDepth view_;
};

}  // namespace objectness

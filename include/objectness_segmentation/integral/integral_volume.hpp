// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace objectness {

/// A summed-volume table over binary voxels [5 in the paper]: the number of set voxels in any box in constant time.
///
/// Entry (x, y, z) holds the number of set voxels in [0, x) x [0, y) x [0, z), x = 0..nx, y = 0..ny, z = 0..nz +
/// padding; above nz it repeats the value at nz, so that a box may reach `padding` voxels over the grid. z runs
/// fastest: the counts of one footprint at all heights lie side by side, and a box that stands on z = 0 needs four of
/// them, not eight.
class IntegralVolume {
 public:
  IntegralVolume() = default;
  IntegralVolume(int nx, int ny, int nz, int padding = 0);

  /// Marks voxel (x, y, z); setting one twice counts once. Only before integrate().
  void set(int x, int y, int z) { table_[index(x + 1, y + 1, z + 1)] = 1; }
  bool isSet(int x, int y, int z) const { return table_[index(x + 1, y + 1, z + 1)] != 0; }

  /// Turns the voxels into sums, once.
  void integrate();

  /// Set voxels in [x0, x1) x [y0, y1) x [z0, z1), all within the grid (z1 up to nz + padding).
  int count(int x0, int x1, int y0, int y1, int z0, int z1) const {
    return count(x0, x1, y0, y1, z1) - count(x0, x1, y0, y1, z0);
  }
  /// The same for a box that stands on z = 0.
  int count(int x0, int x1, int y0, int y1, int height) const {
    return column(x1, y1)[height] - column(x0, y1)[height] - column(x1, y0)[height] + column(x0, y0)[height];
  }
  int total() const { return table_.empty() ? 0 : table_.back(); }

  /// Sums at corner (x, y), indexed by height 0..nz + padding.
  const std::int32_t* column(int x, int y) const { return &table_[index(x, y, 0)]; }

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int nz() const { return nz_; }

 private:
  std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(x) * (ny_ + 1) + y) * stride_ + z; }

  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::size_t stride_ = 1;
  std::vector<std::int32_t> table_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral/voxel_bits.hpp"

namespace objectness {

/// A summed-volume table over binary voxels [5 in the paper]: the number of set voxels in any box in constant time.
///
/// Entry (x, y, z) holds the number of set voxels in [0, x) x [0, y) x [0, z), x = 0..nx, y = 0..ny, z = 0..nz +
/// padding, modulo 2^16; above nz it repeats the value at nz, so that a box may reach `padding` voxels over the grid.
/// z runs fastest: the counts of one footprint at all heights lie side by side, and a box that stands on z = 0 needs
/// four of them, not eight. Half the memory of 32 bits is half the time to build; the sums wrap, their differences are
/// right as long as a box holds fewer than 2^16 voxels, and larger boxes are counted in parts.
class IntegralVolume {
 public:
  IntegralVolume() = default;
  explicit IntegralVolume(const VoxelBits& voxels, int padding = 0) { assign(voxels, padding); }

  /// Sums up other voxels; memory is kept.
  void assign(const VoxelBits& voxels, int padding = 0);

  /// Set voxels in [x0, x1) x [y0, y1) x [z0, z1), all within the grid (z1 up to nz + padding).
  int count(int x0, int x1, int y0, int y1, int z0, int z1) const {
    return count(x0, x1, y0, y1, z1) - count(x0, x1, y0, y1, z0);
  }
  /// The same for a box that stands on z = 0.
  int count(int x0, int x1, int y0, int y1, int height) const {
    if (static_cast<std::int64_t>(x1 - x0) * (y1 - y0) * height > kMostCounted) {
      return countInParts(x0, x1, y0, y1, height);
    }
    return static_cast<std::uint16_t>(column(x1, y1)[height] - column(x0, y1)[height] - column(x1, y0)[height] +
                                      column(x0, y0)[height]);
  }
  int total() const { return total_; }

  /// Sums modulo 2^16 at corner (x, y), indexed by height 0..nz + padding.
  const std::uint16_t* column(int x, int y) const { return &table_[index(x, y)]; }

  /// No box of more voxels than this is counted in one piece.
  static constexpr int kMostCounted = 65535;

  /// Where column (x, y) starts: column(0, 0) + x * strideX() + y * strideY().
  std::ptrdiff_t strideX() const { return static_cast<std::ptrdiff_t>(stride_) * (ny_ + 1); }
  std::ptrdiff_t strideY() const { return static_cast<std::ptrdiff_t>(stride_); }

  /// Entries that may be read beyond the end of any column; those over nz + padding mean nothing.
  static constexpr int kPadding = 8;

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int nz() const { return nz_; }

 private:
  std::size_t index(int x, int y) const { return (static_cast<std::size_t>(x) * (ny_ + 1) + y) * stride_; }
  int countInParts(int x0, int x1, int y0, int y1, int height) const;

  int nx_ = 0, ny_ = 0, nz_ = 0, total_ = 0;
  std::size_t stride_ = 1;
  std::vector<std::uint16_t> table_, line_;
};

}  // namespace objectness

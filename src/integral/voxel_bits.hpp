// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace objectness {

/// Binary voxels of an nx x ny x nz grid: a column of bits for every (x, y), bit z % 64 of its word z / 64.
class VoxelBits {
 public:
  VoxelBits() = default;
  VoxelBits(int nx, int ny, int nz) { reset(nx, ny, nz); }

  /// Another grid, all voxels clear; memory is kept.
  void reset(int nx, int ny, int nz) {
    nx_ = nx, ny_ = ny, nz_ = nz;
    words_ = (nz + 63) / 64;
    bits_.assign(static_cast<std::size_t>(nx) * ny * words_, 0);
  }

  void set(int x, int y, int z) { column(x, y)[z / 64] |= std::uint64_t{1} << (z % 64); }
  bool isSet(int x, int y, int z) const { return column(x, y)[z / 64] >> (z % 64) & 1; }

  std::uint64_t* column(int x, int y) { return &bits_[(static_cast<std::size_t>(x) * ny_ + y) * words_]; }
  const std::uint64_t* column(int x, int y) const { return &bits_[(static_cast<std::size_t>(x) * ny_ + y) * words_]; }

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int nz() const { return nz_; }
  int words() const { return words_; }  ///< of a column

  friend bool operator==(const VoxelBits& a, const VoxelBits& b) {
    return a.nx_ == b.nx_ && a.ny_ == b.ny_ && a.nz_ == b.nz_ && a.bits_ == b.bits_;
  }

 private:
  int nx_ = 0, ny_ = 0, nz_ = 0, words_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace objectness

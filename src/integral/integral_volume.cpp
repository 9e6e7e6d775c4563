// SPDX-License-Identifier: BSD-3-Clause
#include "integral/integral_volume.hpp"

#include <algorithm>

#include "integral/integral_kernel.hpp"

namespace objectness {

void IntegralVolume::assign(const VoxelBits& voxels, int padding) {
  nx_ = voxels.nx(), ny_ = voxels.ny(), nz_ = voxels.nz();
  // Whole groups of eight: the kernel reads a byte of a bit column at a time.
  stride_ = (static_cast<std::size_t>(nz_) + 1 + padding + 7) / 8 * 8;
  const std::size_t slab = (static_cast<std::size_t>(ny_) + 1) * stride_;
  table_.resize((static_cast<std::size_t>(nx_) + 1) * slab + kPadding);
  line_.resize(stride_);
  std::fill_n(table_.begin(), slab, std::uint16_t{0});
  total_ = 0;
  for (int x = 0; x < nx_; ++x) {
    total_ += integrateSlab({voxels.column(x, 0), voxels.words(), ny_, static_cast<int>(stride_)}, &table_[x * slab],
                            line_.data(), &table_[(x + 1) * slab]);
  }
}

int IntegralVolume::countInParts(int x0, int x1, int y0, int y1, int height) const {
  if (x1 - x0 > y1 - y0) {
    const int middle = (x0 + x1) / 2;
    return count(x0, middle, y0, y1, height) + count(middle, x1, y0, y1, height);
  }
  const int middle = (y0 + y1) / 2;
  return count(x0, x1, y0, middle, height) + count(x0, x1, middle, y1, height);
}

}  // namespace objectness

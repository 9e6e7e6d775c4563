// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/integral/integral_volume.hpp"

namespace objectness {

IntegralVolume::IntegralVolume(int nx, int ny, int nz, int padding)
    : nx_(nx),
      ny_(ny),
      nz_(nz),
      stride_(static_cast<std::size_t>(nz) + 1 + padding),
      table_((static_cast<std::size_t>(nx) + 1) * (ny + 1) * stride_, 0) {}

void IntegralVolume::integrate() {
  const std::size_t row = stride_, slab = (static_cast<std::size_t>(ny_) + 1) * stride_;
  std::vector<std::int32_t> line(stride_);
  for (int x = 1; x <= nx_; ++x) {
    // line: sums over this x's slab up to the current y; adding the previous x's entry gives the volume.
    std::fill(line.begin(), line.end(), 0);
    for (int y = 1; y <= ny_; ++y) {
      std::int32_t* entry = &table_[x * slab + y * row];
      std::int32_t run = 0;
      for (std::size_t z = 0; z < stride_; ++z) {
        run += entry[z];
        line[z] += run;
        entry[z] = line[z] + entry[z - slab];
      }
    }
  }
}

}  // namespace objectness

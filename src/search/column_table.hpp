// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "integral/cue_volumes.hpp"
#include "search/bound_kernel.hpp"

namespace objectness {

/// An integral volume as the inner loops read it: the address of a column without a detour.
struct ColumnTable {
  const std::uint16_t* first;
  std::ptrdiff_t stride_x, stride_y;

  explicit ColumnTable(const IntegralVolume& volume)
      : first(volume.column(0, 0)), stride_x(volume.strideX()), stride_y(volume.strideY()) {}

  /// The four corner columns of a footprint, `raise` voxels up. Written in place: a copy, put together of parts that
  /// were just written, costs more than all else in here.
  void corners(int x0, int x1, int y0, int y1, int raise, CornerColumns& columns) const {
    const std::uint16_t *left = first + x0 * stride_x + raise, *right = first + x1 * stride_x + raise;
    const std::ptrdiff_t front = y0 * stride_y, back = y1 * stride_y;
    columns.p11 = right + back;
    columns.p01 = left + back;
    columns.p10 = right + front;
    columns.p00 = left + front;
  }
  /// Set voxels over a footprint up to a height, if there are at most IntegralVolume::kMostCounted.
  int count(int x0, int x1, int y0, int y1, int height) const {
    const std::uint16_t *left = first + x0 * stride_x + height, *right = first + x1 * stride_x + height;
    const std::ptrdiff_t front = y0 * stride_y, back = y1 * stride_y;
    return static_cast<std::uint16_t>(right[back] - left[back] - right[front] + left[front]);
  }
};

/// The same of a superpixel, for any footprint of the grid that meets its bounding box.
struct SuperpixelTable {
  ColumnTable table;
  int left, right, front, back;
  int total;
  float per_total;

  explicit SuperpixelTable(const SuperpixelVolume& superpixel)
      : table(superpixel.volume()),
        left(superpixel.left()),
        right(superpixel.right()),
        front(superpixel.front()),
        back(superpixel.back()),
        total(superpixel.total()),
        per_total(1.0f / static_cast<float>(superpixel.total())) {}

  bool meets(int x0, int x1, int y0, int y1) const { return x0 < right && x1 > left && y0 < back && y1 > front; }
  bool within(int x0, int x1, int y0, int y1) const { return x0 <= left && x1 >= right && y0 <= front && y1 >= back; }
  void corners(int x0, int x1, int y0, int y1, CornerColumns& columns) const {
    table.corners(std::max(x0, left) - left, std::min(x1, right) - left, std::max(y0, front) - front,
                  std::min(y1, back) - front, 0, columns);
  }
};

inline std::vector<SuperpixelTable> superpixelTables(const CueVolumes& volumes) {
  return {volumes.superpixels.begin(), volumes.superpixels.end()};
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "search/bound_kernel.hpp"
#include "search/box_sampler.hpp"

namespace objectness {

/// Where a face of the boxes of a node may lie: low, low + step, ..., high; voxels.
struct FaceRange {
  int low = 0, high = 0, step = 1;

  bool single() const { return low == high; }
  int count() const { return (high - low) / step + 1; }
  void raiseTo(int bound) {
    if (bound > low) low += (bound - low + step - 1) / step * step;
  }
  void lowerTo(int bound) {
    if (bound < high) high -= (high - bound + step - 1) / step * step;
  }
};

/// Both faces of the boxes along one axis.
struct AxisRanges {
  FaceRange from, to;

  /// Drops the faces that no size of the sampling allows. False when none is left.
  bool tighten(const Sampling& s) {
    if (from.low > from.high || to.low > to.high) return false;
    from.lowerTo(to.high - s.min_size);
    to.raiseTo(from.low + s.min_size);
    to.lowerTo(from.high + s.max_size);
    from.raiseTo(to.low - s.max_size);
    return from.low <= from.high && to.low <= to.high;
  }
  bool single() const { return from.single() && to.single(); }
  int outerSize(const Sampling& s) const { return std::min(to.high - from.low, s.max_size); }
  int innerSize(const Sampling& s) const { return std::max(to.low - from.high, s.min_size); }
};

/// A set of boxes: all whose faces and heights lie in these ranges.
struct BoxRanges {
  AxisRanges x, y;
  HeightRange heights;

  bool single() const { return x.single() && y.single(); }
  bool innerEmpty() const { return x.to.low <= x.from.high || y.to.low <= y.from.high; }
};

}  // namespace objectness

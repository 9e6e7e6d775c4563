// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace objectness {

/// The bit columns of one x, ny of them of `words` words each, and how many sums a column gets (a multiple of 8).
struct SlabColumns {
  const std::uint64_t* bits;
  int words, ny, stride;
};

/// One x of an integral volume (IntegralVolume): (ny + 1) * stride sums from those of the x before. line: scratch of
/// `stride` sums. Returns the number of set bits. Plain types only: compiled for several instruction sets.
int integrateSlab(const SlabColumns& columns, const std::uint16_t* before, std::uint16_t* line, std::uint16_t* slab);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

#include "search/bound_kernel.hpp"

namespace objectness {

// Eight heights at a time, by the vector extensions of g++ and clang: on every processor the same results, on those
// with AVX2 one instruction each. Vectors never cross a function's border by value: how they are passed depends on the
// processor that a file is compiled for.
constexpr int kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Integers = std::int32_t __attribute__((vector_size(4 * kLanes)));
using Sums = std::uint16_t __attribute__((vector_size(2 * kLanes)));

#define OBJECTNESS_INLINE inline __attribute__((always_inline))

OBJECTNESS_INLINE void load(const float* from, Floats& lanes) { std::memcpy(&lanes, from, sizeof(lanes)); }
OBJECTNESS_INLINE void store(const Floats& lanes, float* to) { std::memcpy(to, &lanes, sizeof(lanes)); }

/// The counts of heights h .. h + 7, modulo 2^16.
OBJECTNESS_INLINE void sumsAt(const CornerColumns& c, int h, Sums& sums) {
  Sums p11, p01, p10, p00;
  std::memcpy(&p11, c.p11 + h, sizeof(Sums));
  std::memcpy(&p01, c.p01 + h, sizeof(Sums));
  std::memcpy(&p10, c.p10 + h, sizeof(Sums));
  std::memcpy(&p00, c.p00 + h, sizeof(Sums));
  sums = p11 - p01 - p10 + p00;
}

OBJECTNESS_INLINE void toFloats(const Sums& sums, Floats& lanes) {
  lanes = __builtin_convertvector(__builtin_convertvector(sums, Integers), Floats);
}

OBJECTNESS_INLINE void countsAt(const CornerColumns& c, int h, Floats& lanes) {
  Sums sums;
  sumsAt(c, h, sums);
  toFloats(sums, lanes);
}

OBJECTNESS_INLINE void smaller(const Floats& a, const Floats& b, Floats& least) { least = a < b ? a : b; }
OBJECTNESS_INLINE void larger(const Floats& a, const Floats& b, Floats& most) { most = a > b ? a : b; }

}  // namespace objectness

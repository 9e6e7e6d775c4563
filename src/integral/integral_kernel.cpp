// SPDX-License-Identifier: BSD-3-Clause
#include "integral/integral_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

/// below[byte][i]: the set bits of `byte` below bit i.
struct BitsBelow {
  std::uint16_t below[256][8];
  std::uint8_t all[256];

  constexpr BitsBelow() : below(), all() {
    for (int byte = 0; byte < 256; ++byte) {
      std::uint16_t count = 0;
      for (int i = 0; i < 8; ++i) {
        below[byte][i] = count;
        count = static_cast<std::uint16_t>(count + (byte >> i & 1));
      }
      all[byte] = static_cast<std::uint8_t>(count);
    }
  }
};
constexpr BitsBelow kBits;

}  // namespace

OBJECTNESS_CLONES("avx2")
int integrateSlab(const SlabColumns& columns, const std::uint16_t* before, std::uint16_t* line, std::uint16_t* slab) {
  const int stride = columns.stride, words = columns.words;
  int total = 0;
  for (int z = 0; z < stride; ++z) slab[z] = line[z] = 0;
  for (int y = 0; y < columns.ny; ++y) {
    const std::uint64_t* column = columns.bits + static_cast<long>(y) * words;
    std::uint64_t any = 0;
    for (int w = 0; w < words; ++w) any |= column[w];
    before += stride;
    slab += stride;
    // line: the sums over this x up to the current y; with those of the x before they make the volume.
    if (any != 0) {
      std::uint16_t below = 0;
      for (int group = 0; group < stride / 8; ++group) {
        const unsigned byte = group / 8 < words ? column[group / 8] >> (group % 8 * 8) & 0xFF : 0;
        const std::uint16_t* inside = kBits.below[byte];
        for (int i = 0; i < 8; ++i)
          line[group * 8 + i] = static_cast<std::uint16_t>(line[group * 8 + i] + below + inside[i]);
        below = static_cast<std::uint16_t>(below + kBits.all[byte]);
      }
      total += below;
    }
    for (int z = 0; z < stride; ++z) slab[z] = static_cast<std::uint16_t>(line[z] + before[z]);
  }
  return total;
}

}  // namespace objectness

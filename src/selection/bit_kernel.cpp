// SPDX-License-Identifier: BSD-3-Clause
#include "selection/bit_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("popcnt")
int countBits(const std::uint64_t* set, std::size_t words) {
  int count = 0;
  for (std::size_t i = 0; i < words; ++i) count += __builtin_popcountll(set[i]);
  return count;
}

OBJECTNESS_CLONES("popcnt")
int countCommonBits(const std::uint64_t* a, const std::uint64_t* b, std::size_t words) {
  int count = 0;
  for (std::size_t i = 0; i < words; ++i) count += __builtin_popcountll(a[i] & b[i]);
  return count;
}

}  // namespace objectness

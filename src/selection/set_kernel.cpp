// SPDX-License-Identifier: BSD-3-Clause
#include "selection/set_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
OBJECTNESS_CLONES("popcnt")
int intersectRows(const std::uint64_t* x_high, const std::uint64_t* x_low, const std::uint64_t* y_high,
                  const std::uint64_t* y_low, const std::uint64_t* z_high, std::uint64_t mask, int group_words,
                  std::uint64_t* points, std::uint64_t& groups) {
  int count = 0;
  groups = 0;
  for (; mask != 0; mask &= mask - 1) {
    const int group = __builtin_ctzll(mask);
    std::uint64_t any = 0;
    for (int w = group * group_words; w < (group + 1) * group_words; ++w) {
      const std::uint64_t inside = x_high[w] & ~x_low[w] & y_high[w] & ~y_low[w] & z_high[w];
      points[w] = inside;
      any |= inside;
      count += __builtin_popcountll(inside);
    }
    if (any != 0) groups |= std::uint64_t{1} << group;
  }
  return count;
}

OBJECTNESS_CLONES("popcnt")
int countCommon(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t mask, int group_words) {
  int count = 0;
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) count += __builtin_popcountll(a[w] & b[w]);
  }
  return count;
}

bool haveCommon(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t mask, int group_words) {
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      if ((a[w] & b[w]) != 0) return true;
    }
  }
  return false;
}

OBJECTNESS_CLONES("popcnt")
int countCommon(const std::uint64_t* a, const std::uint64_t* b, const std::uint64_t* c, std::uint64_t mask,
                int group_words) {
  int count = 0;
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) count += __builtin_popcountll(a[w] & b[w] & c[w]);
  }
  return count;
}

void findHeld(const Counters& held, std::uint64_t mask, int group_words, std::uint64_t* none, std::uint64_t* one,
              std::uint64_t* two) {
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      const std::uint64_t low = held.planes[w], next = held.count > 1 ? held.planes[held.words + w] : 0;
      std::uint64_t high = 0;
      for (int b = 2; b < held.count; ++b) high |= held.planes[b * held.words + w];
      none[w] = ~(low | next | high);
      one[w] = low & ~(next | high);
      two[w] = next & ~(low | high);
    }
  }
}

OBJECTNESS_CLONES("popcnt")
HeldCounts countHeld(const std::uint64_t* set, std::uint64_t mask, int group_words, const HeldSets& held,
                     const Counters& beside, int exactly) {
  const std::uint64_t* exact = exactly == 0 ? held.none : held.one;
  const std::uint64_t* further = exactly == 0 ? held.one : held.two;
  HeldCounts counts = {0, 0, 0, 0, 0};
  for (; mask != 0; mask &= mask - 1) {
    const int group = __builtin_ctzll(mask);
    std::uint64_t shared = 0;
    for (int w = group * group_words; w < (group + 1) * group_words; ++w) {
      counts.none += __builtin_popcountll(set[w] & held.none[w]);
      counts.one += __builtin_popcountll(set[w] & held.one[w]);
      counts.two += __builtin_popcountll(set[w] & held.two[w]);
      shared |= set[w] & further[w];
      const std::uint64_t own = set[w] & exact[w];
      if (own == 0) continue;
      for (int b = 0; b < beside.count; ++b) {
        counts.unexplained += static_cast<long>(__builtin_popcountll(own & beside.planes[b * beside.words + w])) << b;
      }
    }
    if (shared != 0) counts.shared |= std::uint64_t{1} << group;
  }
  return counts;
}

void increment(const std::uint64_t* set, std::uint64_t mask, int group_words, int count, int words,
               std::uint64_t* planes) {
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      std::uint64_t carry = set[w];
      for (int b = 0; b < count && carry != 0; ++b) {
        std::uint64_t& plane = planes[b * words + w];
        const std::uint64_t sum = plane ^ carry;
        carry &= plane;
        plane = sum;
      }
    }
  }
}

void decrement(const std::uint64_t* set, std::uint64_t mask, int group_words, int count, int words,
               std::uint64_t* planes) {
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      std::uint64_t borrow = set[w];
      for (int b = 0; b < count && borrow != 0; ++b) {
        std::uint64_t& plane = planes[b * words + w];
        const std::uint64_t difference = plane ^ borrow;
        borrow &= ~plane;
        plane = difference;
      }
    }
  }
}

}  // namespace objectness

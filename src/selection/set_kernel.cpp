// SPDX-License-Identifier: BSD-3-Clause
#include "set_kernel.hpp"

#include "objectness_segmentation/common/target_clones.hpp"

namespace objectness {
namespace {

/// The sets of points that are in no, one and two boxes, of one word.
struct HeldWord {
  std::uint64_t none, one, two;
};

inline __attribute__((always_inline)) HeldWord heldWord(const Counters& held, int w) {
  const std::uint64_t low = held.planes[w], next = held.count > 1 ? held.planes[held.words + w] : 0;
  std::uint64_t high = 0;
  for (int b = 2; b < held.count; ++b) high |= held.planes[b * held.words + w];
  return {~(low | next | high), low & ~(next | high), next & ~(low | high)};
}

}  // namespace

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

OBJECTNESS_CLONES("popcnt")
HeldCounts countHeld(const std::uint64_t* set, std::uint64_t mask, int group_words, const Counters& held,
                     const Counters& beside, int exactly) {
  HeldCounts counts = {0, 0, 0, 0, 0};
  int all = 0;
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      if (set[w] == 0) continue;
      const HeldWord in = heldWord(held, w);
      all += __builtin_popcountll(set[w]);
      counts.none += __builtin_popcountll(set[w] & in.none);
      counts.one += __builtin_popcountll(set[w] & in.one);
      counts.two += __builtin_popcountll(set[w] & in.two);
      const std::uint64_t exact = set[w] & (exactly == 0 ? in.none : in.one);
      if (exact == 0) continue;
      for (int b = 0; b < beside.count; ++b) {
        counts.unexplained += static_cast<long>(__builtin_popcountll(exact & beside.planes[b * beside.words + w])) << b;
      }
    }
  }
  counts.more = all - counts.none - counts.one - counts.two;
  return counts;
}

void selectHeld(const std::uint64_t* set, std::uint64_t mask, int group_words, const Counters& held, int exactly,
                std::uint64_t* selected) {
  for (; mask != 0; mask &= mask - 1) {
    const int first = __builtin_ctzll(mask) * group_words;
    for (int w = first; w < first + group_words; ++w) {
      const HeldWord in = heldWord(held, w);
      selected[w] = set[w] & (exactly == 1 ? in.one : in.two);
    }
  }
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

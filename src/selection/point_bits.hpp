// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace objectness {

/// How sets of scene points are laid out: a bit for each point, in up to 64 groups of whole words. Points that lie
/// close together have bits close together, so that a box meets few groups.
struct PointLayout {
  int points = 0;
  int group_words = 1;
  int groups = 0;

  explicit PointLayout(int count = 0) : points(count) {
    const int words = (count + 63) / 64;
    group_words = std::max(1, (words + 63) / 64);
    groups = (words + group_words - 1) / group_words;
  }
  int words() const { return groups * group_words; }
};

/// A set of scene points.
struct PointBits {
  std::uint64_t groups = 0;          ///< bit g: group g is not empty
  std::vector<std::uint64_t> words;  ///< PointLayout::words() of them

  void set(int point, const PointLayout& layout) {
    words[point / 64] |= std::uint64_t{1} << (point % 64);
    groups |= std::uint64_t{1} << (point / 64 / layout.group_words);
  }
};

}  // namespace objectness

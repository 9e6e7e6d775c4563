// SPDX-License-Identifier: BSD-3-Clause
#include "selection/point_set.hpp"

#include "selection/bit_kernel.hpp"

namespace objectness {
namespace {

constexpr int kBits = 64;

}  // namespace

int countPoints(const PointSet& set) { return countBits(set.data(), set.size()); }

int countShared(const PointSet& a, const PointSet& b) { return countCommonBits(a.data(), b.data(), a.size()); }

bool sharePoints(const PointSet& a, const PointSet& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] & b[i]) return true;
  }
  return false;
}

std::vector<int> listPoints(const PointSet& set) {
  std::vector<int> list;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set[i] == 0) continue;
    for (int bit = 0; bit < kBits; ++bit) {
      if (set[i] >> bit & 1) list.push_back(static_cast<int>(i) * kBits + bit);
    }
  }
  return list;
}

}  // namespace objectness

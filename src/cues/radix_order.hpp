// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace objectness {

/// Indices of values >= 0 in descending order, equal ones as they come: a stable sort in time linear in their number.
inline std::vector<int> descendingOrder(const std::vector<float>& values) {
  constexpr int kDigitBits = 11, kDigits = 3;  // of 32
  constexpr std::uint32_t kMask = (1u << kDigitBits) - 1;
  struct Entry {
    std::uint32_t key;
    int index;
  };
  std::vector<Entry> entries(values.size()), sorted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint32_t bits;  // of values >= 0 rise with them
    std::memcpy(&bits, &values[i], sizeof bits);
    entries[i] = {~bits, static_cast<int>(i)};
  }
  for (int digit = 0; digit < kDigits; ++digit) {
    const int shift = digit * kDigitBits;
    std::array<std::uint32_t, kMask + 1> place{};
    for (const Entry& entry : entries) ++place[entry.key >> shift & kMask];
    std::uint32_t sum = 0;
    for (std::uint32_t& count : place) {
      const std::uint32_t own = count;
      count = sum;
      sum += own;
    }
    for (const Entry& entry : entries) sorted[place[entry.key >> shift & kMask]++] = entry;
    entries.swap(sorted);
  }
  std::vector<int> order;
  order.reserve(values.size());
  for (const Entry& entry : entries) order.push_back(entry.index);
  return order;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>
#include <utility>

#include "objectness_segmentation/search/search.hpp"

namespace objectness {
namespace {

/// A number that is smaller for better objectness.
std::uint32_t rankOf(float objectness) {
  objectness += 0.0f;  // -0 is 0
  std::uint32_t bits;
  std::memcpy(&bits, &objectness, sizeof(bits));
  return bits >> 31 ? bits : ~bits & 0x7FFFFFFFu;
}

struct Ranked {
  std::uint32_t rank, index;
};

/// Stable, by rank: digit by digit, the last one first.
void radixSort(std::vector<Ranked>& entries) {
  constexpr int kDigitBits = 11, kDigits = 1 << kDigitBits;
  std::vector<Ranked> sorted(entries.size());
  for (int shift = 0; shift < 32; shift += kDigitBits) {
    const auto digit = [shift](const Ranked& entry) { return entry.rank >> shift & (kDigits - 1); };
    std::vector<std::uint32_t> next(kDigits, 0);
    for (const Ranked& entry : entries) ++next[digit(entry)];
    std::uint32_t first = 0;
    for (std::uint32_t& place : next) first += std::exchange(place, first);
    for (const Ranked& entry : entries) sorted[next[digit(entry)]++] = entry;
    entries.swap(sorted);
  }
}

}  // namespace

void sortBestFirst(std::vector<ScoredBox>& boxes) {
  // Numbers are sorted instead of boxes, which are moved only once.
  std::vector<Ranked> order(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order[i] = {rankOf(boxes[i].objectness), static_cast<std::uint32_t>(i)};
  radixSort(order);
  std::vector<ScoredBox> sorted;
  sorted.reserve(boxes.size());
  for (const Ranked& entry : order) sorted.push_back(boxes[entry.index]);
  // Ties by the order of enumeration, which they often have already.
  for (auto first = sorted.begin(); first != sorted.end();) {
    auto last = first + 1;
    bool in_order = true;
    for (; last != sorted.end() && last->objectness == first->objectness; ++last) in_order &= better(*(last - 1), *last);
    if (!in_order) std::sort(first, last, better);
    first = last;
  }
  boxes.swap(sorted);
}

}  // namespace objectness

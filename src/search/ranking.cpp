// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>

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

}  // namespace

void sortBestFirst(std::vector<ScoredBox>& boxes) {
  // Numbers are sorted instead of boxes, which are moved only once.
  std::vector<std::uint64_t> order(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order[i] = std::uint64_t{rankOf(boxes[i].objectness)} << 32 | i;
  std::sort(order.begin(), order.end());
  std::vector<ScoredBox> sorted;
  sorted.reserve(boxes.size());
  for (const std::uint64_t entry : order) sorted.push_back(boxes[entry & 0xFFFFFFFFu]);
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(),
                                   [&](const ScoredBox& scored) { return scored.objectness != first->objectness; });
    std::sort(first, last, better);
    first = last;
  }
  boxes.swap(sorted);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "search/ranking.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <utility>

#include "common/parallel.hpp"

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
  std::uint32_t rank;
  const ScoredBox* box;
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

/// Numbers are sorted instead of boxes, which are moved only once. entries: in the order of enumeration where
/// objectness is the same, mostly.
void writeBestFirst(std::vector<Ranked>& entries, ScoredBox* sorted) {
  radixSort(entries);
  ScoredBox* end = sorted;
  for (const Ranked& entry : entries) *end++ = *entry.box;
  for (ScoredBox* first = sorted; first != end;) {
    ScoredBox* last = first + 1;
    bool in_order = true;
    for (; last != end && last->objectness == first->objectness; ++last) in_order &= better(*(last - 1), *last);
    if (!in_order) std::sort(first, last, better);
    first = last;
  }
}

using Lists = std::vector<std::vector<ScoredBox>>;

/// Objectness that divides the boxes of sorted lists into parts of about the same size, best first.
std::vector<float> cutsBetween(const Lists& lists, std::size_t boxes, int parts) {
  const std::size_t stride = std::max<std::size_t>(1, boxes / (64 * static_cast<std::size_t>(parts)));
  std::vector<float> samples;
  for (const auto& list : lists) {
    for (std::size_t i = 0; i < list.size(); i += stride) samples.push_back(list[i].objectness);
  }
  std::sort(samples.begin(), samples.end(), std::greater<float>());
  std::vector<float> cuts;
  for (int part = 1; part < parts; ++part) cuts.push_back(samples[part * samples.size() / parts]);
  return cuts;
}

}  // namespace

void sortBestFirst(std::vector<ScoredBox>& boxes) {
  std::vector<Ranked> entries(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) entries[i] = {rankOf(boxes[i].objectness), &boxes[i]};
  std::vector<ScoredBox> sorted(boxes.size());
  writeBestFirst(entries, sorted.data());
  boxes.swap(sorted);
}

std::vector<ScoredBox> mergeBestFirst(const Lists& lists, int threads) {
  constexpr std::size_t kPart = 8192;
  std::size_t boxes = 0;
  for (const auto& list : lists) boxes += list.size();
  const int parts = static_cast<int>(boxes / kPart) + 1;
  const std::vector<float> cuts = cutsBetween(lists, boxes, parts);
  // Per part and list: the first box of the part; then the end of all.
  std::vector<std::vector<std::size_t>> firsts(parts + 1);
  std::vector<std::size_t> places(parts + 1, 0);
  for (int part = 0; part <= parts; ++part) {
    for (const auto& list : lists) {
      const auto isBefore = [&](const ScoredBox& box) { return box.objectness > cuts[part - 1]; };
      const auto first = part == 0       ? list.begin()
                         : part == parts ? list.end()
                                         : std::partition_point(list.begin(), list.end(), isBefore);
      firsts[part].push_back(first - list.begin());
      places[part] += firsts[part].back();
    }
  }
  std::vector<ScoredBox> merged(boxes);
  parallelFor(parts, threads, [&](int part) {
    std::vector<Ranked> entries;
    entries.reserve(places[part + 1] - places[part]);
    for (std::size_t l = 0; l < lists.size(); ++l) {
      for (std::size_t i = firsts[part][l]; i < firsts[part + 1][l]; ++i) {
        entries.push_back({rankOf(lists[l][i].objectness), &lists[l][i]});
      }
    }
    writeBestFirst(entries, merged.data() + places[part]);
  });
  return merged;
}

}  // namespace objectness

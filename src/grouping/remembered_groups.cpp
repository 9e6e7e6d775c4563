// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/remembered_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "grouping/links.hpp"

namespace objectness {
namespace {

constexpr double kMostly = 0.5;  // of a piece's known pixels

}  // namespace

RememberedGroups::RememberedGroups(const Pieces& pieces, const GroupingMemory& memory)
    : label_(pieces.count(), 0), pixels_(pieces.count()), known_(pieces.count(), 0) {
  const int width = pieces.label.cols, factor = std::max(1, memory.labels.cols / std::max(1, width));
  for (int k = 0; k < pieces.count(); ++k) {
    std::map<int, int> counts;
    for (const int i : pieces.pieces[k].pixels) {
      const int v = i / width * factor + factor / 2, u = i % width * factor + factor / 2;
      if (v >= memory.labels.rows || u >= memory.labels.cols) continue;
      const int label = memory.labels(v, u);
      if (label == GroupingMemory::kUnknown) continue;
      ++known_[k];
      if (label >= kFirstObjectLabel) ++counts[label];
    }
    for (const auto& [label, count] : counts) {
      if (static_cast<std::size_t>(label) >= sizes_.size()) sizes_.resize(label + 1, 0);
      sizes_[label] += count;
      pixels_[k].emplace_back(label, count);
      if (count > kMostly * known_[k]) label_[k] = label;
    }
  }
}

std::vector<std::vector<int>> RememberedGroups::groups() const {
  std::map<int, std::vector<int>> by_label;
  for (std::size_t k = 0; k < label_.size(); ++k) {
    if (label_[k] > 0) by_label[label_[k]].push_back(static_cast<int>(k));
  }
  std::vector<std::vector<int>> groups;
  for (auto& group : by_label) groups.push_back(std::move(group.second));
  return groups;
}

void RememberedGroups::weighLinks(double log_odds, std::vector<Link>& links) const {
  for (Link& link : links) {
    const int a = label_[link.first], b = label_[link.second];
    if (a == 0 || b == 0) continue;
    const double odds = logOdds(link.probability) + (a == b ? log_odds : -log_odds);
    link.probability = static_cast<float>(1 / (1 + std::exp(-odds)));
  }
}

void RememberedGroups::compare(std::vector<GroupHypothesis>& groups) const {
  for (GroupHypothesis& group : groups) {
    std::map<int, int> counts;
    int known = 0;
    for (const int k : group.pieces) {
      known += known_[k];
      for (const auto& [label, count] : pixels_[k]) counts[label] += count;
    }
    if (known == 0) continue;
    double best = 0;
    int of_none = known;
    for (const auto& [label, count] : counts) {
      best = std::max(best, count / static_cast<double>(known + sizes_[label] - count));
      of_none -= count;
    }
    const double none = of_none / static_cast<double>(known);
    group.remembered = static_cast<float>(std::max(0.0, 2 * best - 1) - std::max(0.0, 2 * none - 1));
  }
}

}  // namespace objectness

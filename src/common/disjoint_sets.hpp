// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace objectness {

/// Labels 0, 1, ... that turn out to be the same; the root of a set is its smallest label.
class DisjointSets {
 public:
  DisjointSets() = default;
  /// 0..size-1, each a set of its own.
  explicit DisjointSets(int size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  int create() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int size() const { return static_cast<int>(parent_.size()); }
  int root(int label) {
    while (parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
    return label;
  }
  /// Returns the common root.
  int join(int a, int b) {
    a = root(a), b = root(b);
    return parent_[std::max(a, b)] = std::min(a, b);
  }
  /// For each label the number of its set, 0..count-1 in the order of their smallest labels.
  std::vector<int> numbers(int& count) {
    std::vector<int> number(parent_.size());
    count = 0;
    for (int k = 0; k < static_cast<int>(parent_.size()); ++k) number[k] = root(k) == k ? count++ : number[root(k)];
    return number;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace objectness

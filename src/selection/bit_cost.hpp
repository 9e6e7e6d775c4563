// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "selection/bit_selection.hpp"
#include "selection/set_kernel.hpp"

namespace objectness {

/// GlobalCost on bit sets. How many active boxes hold a point, and how many have it beside them, are numbers in bit
/// planes: a flip is a few words of additions, what it would cost a few words of counting.
class BitCost {
 public:
  /// The problem must outlive the cost.
  BitCost(const BitProblem& problem, const SelectionConfig& config);

  double cost() const { return cost_; }
  const std::vector<bool>& active() const { return active_; }
  int size() const { return static_cast<int>(active_.size()); }
  double flipDelta(int i) const;
  double flip(int i);

  /// Undoes the flips made since the cost was `cost`.
  void undo(const std::vector<int>& flips, double cost);

  /// The boxes that hold a point of box i and are active (or are not), ascending.
  std::vector<int> rivals(int i, bool active) const;

  /// Nothing that matters to the moves of box i has changed since they were found not to gain.
  bool settled(int i) const;
  void settle(int i);
  void changed(const std::vector<int>& flips);

 private:
  struct Planes {
    std::vector<std::uint64_t> bits;
    int count = 1;
  };
  double countDelta(int i) const;
  void toggle(int i);
  void adjust(const PointBits& set, bool add, int most, Planes& planes);
  bool share(int i, int j) const;
  Counters counters(const Planes& planes) const { return {planes.bits.data(), planes.count, words_}; }
  HeldSets sets() const { return {none_.data(), one_.data(), two_.data()}; }
  std::uint64_t reach(int i) const;

  const BitProblem& problem_;
  const SelectionConfig config_;
  const int words_;
  Planes held_, beside_;
  std::vector<std::uint64_t> none_, one_, two_;  ///< the points in as many active boxes: held_, spelt out
  std::vector<int> points_;                      ///< in each box
  std::vector<bool> active_;
  std::vector<int> actives_;  ///< ascending
  double cost_ = 0;
  struct Counted {
    int box = -1;  ///< -1: stale, the selection has changed
    double delta = 0;
  };
  mutable Counted last_;                ///< what is asked first of a box is often asked of it again
  std::vector<std::uint64_t> changes_;  ///< the groups that each change touched
  struct Settled {
    std::size_t changes = 0;   ///< how many there were
    std::uint64_t groups = 0;  ///< that matter
    bool is = false;
  };
  std::vector<Settled> settled_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace objectness {

/// What the k-th best of all boxes found so far reaches at least: no box below it is one of the k best. Shared by the
/// threads of a search.
class RunningThreshold {
 public:
  /// No box is looked for below `lowest`, none reaches more than `highest`.
  RunningThreshold(int k, double lowest, double highest);

  double value() const { return value_.load(std::memory_order_relaxed); }
  void add(float objectness);

 private:
  double floorOf(int bucket) const { return lowest_ + bucket * width_; }

  const int k_;
  const double lowest_, width_;
  std::vector<std::atomic<std::int32_t>> counts_;  ///< boxes by objectness, in steps of width_
  std::atomic<double> value_;
  std::atomic<std::int64_t> added_{0};
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "search/running_threshold.hpp"

#include <algorithm>

namespace objectness {
namespace {

constexpr int kBuckets = 2048;
constexpr int kEvery = 32;  // boxes between two looks at the counts

}  // namespace

RunningThreshold::RunningThreshold(int k, double lowest, double highest)
    : k_(k), lowest_(lowest), width_(std::max(highest - lowest, 1e-6) / kBuckets), counts_(kBuckets), value_(lowest) {}

void RunningThreshold::add(float objectness) {
  const double position = (static_cast<double>(objectness) - lowest_) / width_;
  const int bucket = std::clamp(static_cast<int>(position), 0, kBuckets - 1);
  // Rounding must not put a box into a bucket that begins above it.
  counts_[floorOf(bucket) > objectness ? std::max(bucket - 1, 0) : bucket].fetch_add(1, std::memory_order_relaxed);
  const std::int64_t added = added_.fetch_add(1, std::memory_order_relaxed) + 1;
  if (added < k_ || added % kEvery != 0) return;
  std::int64_t above = 0;
  for (int b = kBuckets - 1; b > 0; --b) {
    above += counts_[b].load(std::memory_order_relaxed);
    if (above < k_) continue;
    double known = value_.load(std::memory_order_relaxed);
    while (known < floorOf(b) && !value_.compare_exchange_weak(known, floorOf(b), std::memory_order_relaxed)) {
    }
    return;
  }
}

}  // namespace objectness

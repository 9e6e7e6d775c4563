// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "selection/set_kernel.hpp"
#include "selection/suppression.hpp"

namespace objectness {

/// The boxes kept so far.
class KeptBoxes {
 public:
  KeptBoxes(const std::vector<SurvivingBox>& boxes, const PointLayout& layout, const FilterConfig& config)
      : boxes_(boxes), layout_(layout), config_(config) {}

  int size() const { return static_cast<int>(kept_.size()); }
  void add(int count, int cluster) { kept_.push_back({static_cast<int>(kept_.size()), count, cluster}); }

  /// Whether one of them is in conflict with a box: "share at least 95 % of scene points within them, with respect to
  /// the box with more points" (Sec. 4.1). Those before `first` are known not to be. recent: those of its cluster that
  /// suppressed a box, the last one first.
  bool conflictsWith(const PointBits& points, int count, int cluster, int first, std::vector<int>& recent) const {
    for (std::size_t k = 0; k < recent.size(); ++k) {
      if (!inConflict(kept_[recent[k]], points, count, cluster)) continue;
      std::rotate(recent.begin(), recent.begin() + k, recent.begin() + k + 1);
      return true;
    }
    for (int k = size() - 1; k >= first; --k) {
      if (!inConflict(kept_[k], points, count, cluster)) continue;
      recent.insert(recent.begin(), k);
      if (recent.size() > kRemembered) recent.pop_back();
      return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kRemembered = 16;
  struct Kept {
    int index, count, cluster;
  };

  bool inConflict(const Kept& kept, const PointBits& points, int count, int cluster) const {
    const double needed = config_.conflict_share * std::max(count, kept.count);
    if (std::min(count, kept.count) < needed) return false;
    if (!config_.across_clusters && kept.cluster != cluster) return false;
    const PointBits& other = boxes_[kept.index].points;
    const std::uint64_t groups = points.groups & other.groups;
    return groups != 0 && countCommon(points.words.data(), other.words.data(), groups, layout_.group_words) >= needed;
  }

  const std::vector<SurvivingBox>& boxes_;
  const PointLayout& layout_;
  const FilterConfig& config_;
  std::vector<Kept> kept_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "suppression.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "leader_clusters.hpp"
#include "set_kernel.hpp"

namespace objectness {
namespace {

Eigen::Vector3d centreOf(const Box& box, const Grid& grid) {
  return grid.toTable({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), 0.5 * box.height});
}

LeaderClusters clustersOver(const std::vector<Grid>& grids, double radius_m) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const Grid& grid : grids) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d p =
          grid.toTable({corner & 1 ? 1.0 * grid.nx : 0.0, corner & 2 ? 1.0 * grid.ny : 0.0, corner & 4 ? 1.0 * grid.nz : 0.0});
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {radius_m, low, high};
}

/// The boxes kept so far.
class KeptBoxes {
 public:
  KeptBoxes(const std::vector<SurvivingBox>& boxes, const PointLayout& layout, const FilterConfig& config)
      : boxes_(boxes), layout_(layout), config_(config) {}

  void add(int count, int cluster) { kept_.push_back({static_cast<int>(kept_.size()), count, cluster}); }

  /// Whether one of them is in conflict with a box: "share at least 95 % of scene points within them, with respect to
  /// the box with more points" (Sec. 4.1). recent: those of its cluster that suppressed a box, the last one first.
  bool conflictsWith(const PointBits& points, int count, int cluster, std::vector<int>& recent) const {
    for (std::size_t k = 0; k < recent.size(); ++k) {
      if (!inConflict(kept_[recent[k]], points, count, cluster)) continue;
      std::rotate(recent.begin(), recent.begin() + k, recent.begin() + k + 1);
      return true;
    }
    for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept) {
      if (!inConflict(*kept, points, count, cluster)) continue;
      recent.insert(recent.begin(), kept->index);
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
    return groups != 0 &&
           countCommon(points.words.data(), other.words.data(), groups, layout_.group_words) >= needed;
  }

  const std::vector<SurvivingBox>& boxes_;
  const PointLayout& layout_;
  const FilterConfig& config_;
  std::vector<Kept> kept_;
};

/// A copy with nothing in the groups that are not the set's.
PointBits cleared(const PointBits& points, const PointLayout& layout) {
  PointBits copy{points.groups, std::vector<std::uint64_t>(layout.words(), 0)};
  for (std::uint64_t left = points.groups; left != 0; left &= left - 1) {
    const int first = __builtin_ctzll(left) * layout.group_words;
    std::copy_n(points.words.begin() + first, layout.group_words, copy.words.begin() + first);
  }
  return copy;
}

}  // namespace

std::vector<SurvivingBox> suppressBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                        const std::vector<BoxPoints>& points, const PointLayout& layout,
                                        const FilterConfig& config) {
  LeaderClusters clusters = clustersOver(grids, config.cluster_radius_m);
  struct Members {
    int looked_at = 0;
    std::vector<int> suppressors;
  };
  std::vector<Members> members;
  std::vector<SurvivingBox> survivors;
  KeptBoxes kept(survivors, layout, config);
  PointBits held{0, std::vector<std::uint64_t>(layout.words(), 0)};
  for (const auto& scored : boxes) {
    const std::size_t cluster = clusters.assign(centreOf(scored.box, grids[scored.box.angle]));
    if (cluster == members.size()) members.emplace_back();
    if (members[cluster].looked_at == config.max_boxes_per_cluster) continue;
    ++members[cluster].looked_at;
    const int count = points[scored.box.angle].inside(scored.box, 0, 0, held);
    if (count == 0 || kept.conflictsWith(held, count, static_cast<int>(cluster), members[cluster].suppressors)) continue;
    survivors.push_back({scored, cleared(held, layout)});
    kept.add(count, static_cast<int>(cluster));
  }
  return survivors;
}

}  // namespace objectness

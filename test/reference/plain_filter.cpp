// SPDX-License-Identifier: BSD-3-Clause
#include "reference/plain_filter.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "selection/cell_key.hpp"

namespace objectness {
namespace {

Eigen::Vector3d centreOf(const Box& box, const Grid& grid) {
  return grid.toTable({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), 0.5 * box.height});
}

/// Leader clustering: a box joins the nearest leader within the radius, or leads a cluster of its own.
class Clusters {
 public:
  explicit Clusters(double radius_m) : radius_(radius_m) {}

  int assign(const Eigen::Vector3d& centre) {
    const Cell cell = cellOf(centre, radius_);
    int nearest = -1;
    double nearest_distance = radius_;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = leaders_in_.find(keyOf(cell + Cell(dx, dy, dz)));
          if (found == leaders_in_.end()) continue;
          for (const int leader : found->second) {
            const double distance = (leaders_[leader] - centre).norm();
            if (distance > nearest_distance || (distance == nearest_distance && nearest >= 0 && nearest < leader))
              continue;
            nearest = leader;
            nearest_distance = distance;
          }
        }
      }
    }
    if (nearest >= 0) return nearest;
    leaders_.push_back(centre);
    leaders_in_[keyOf(cell)].push_back(static_cast<int>(leaders_.size()) - 1);
    return static_cast<int>(leaders_.size()) - 1;
  }

 private:
  double radius_;
  std::vector<Eigen::Vector3d> leaders_;
  std::unordered_map<std::uint64_t, std::vector<int>> leaders_in_;
};

/// The boxes kept so far, found by how many points they hold.
class KeptHypotheses {
 public:
  KeptHypotheses(const std::vector<BoxHypothesis>& hypotheses, const FilterConfig& config)
      : hypotheses_(hypotheses), config_(config) {}

  void add(int index, int points, int cluster) { with_points_[points].push_back({index, cluster}); }

  /// Whether one of them is in conflict with a box: "share at least 95 % of scene points within them, with respect to
  /// the box with more points" (Sec. 4.1). Only boxes of nearly as many points can be.
  bool conflictsWith(const PointSet& points, int count, int cluster) const {
    const double share = config_.conflict_share;
    const auto last = with_points_.upper_bound(static_cast<int>(std::ceil(count / share)));
    for (auto kept = with_points_.lower_bound(static_cast<int>(std::floor(count * share))); kept != last; ++kept) {
      const double needed = share * std::max(count, kept->first);
      if (std::min(count, kept->first) < needed) continue;
      for (const Entry& entry : kept->second) {
        if (!config_.across_clusters && entry.cluster != cluster) continue;
        if (countShared(points, hypotheses_[entry.index].points) >= needed) return true;
      }
    }
    return false;
  }

 private:
  struct Entry {
    int index, cluster;
  };
  const std::vector<BoxHypothesis>& hypotheses_;
  const FilterConfig& config_;
  std::map<int, std::vector<Entry>> with_points_;
};

}  // namespace

std::vector<BoxHypothesis> filterBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                       const std::vector<PointOverlap>& overlaps, const FilterConfig& config) {
  Clusters clusters(config.cluster_radius_m);
  std::vector<int> members;  // per cluster: boxes looked at so far
  std::vector<BoxHypothesis> hypotheses;
  KeptHypotheses kept(hypotheses, config);
  for (const auto& scored : boxes) {
    const int cluster = clusters.assign(centreOf(scored.box, grids[scored.box.angle]));
    if (cluster == static_cast<int>(members.size())) members.push_back(0);
    if (members[cluster] == config.max_boxes_per_cluster) continue;
    ++members[cluster];
    PointSet points = overlaps[scored.box.angle].inside(scored.box);
    const int count = countPoints(points);
    if (count == 0 || kept.conflictsWith(points, count, cluster)) continue;
    kept.add(static_cast<int>(hypotheses.size()), count, cluster);
    hypotheses.push_back({scored, std::move(points)});
  }
  return hypotheses;
}

}  // namespace objectness

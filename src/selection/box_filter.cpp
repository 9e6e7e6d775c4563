// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/box_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

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
    const std::array<int, 3> cell = cellOf(centre);
    int nearest = -1;
    double nearest_distance = radius_;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = leaders_in_.find({cell[0] + dx, cell[1] + dy, cell[2] + dz});
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
    leaders_in_[cell].push_back(static_cast<int>(leaders_.size()) - 1);
    return static_cast<int>(leaders_.size()) - 1;
  }

 private:
  std::array<int, 3> cellOf(const Eigen::Vector3d& p) const {
    return {static_cast<int>(std::floor(p.x() / radius_)), static_cast<int>(std::floor(p.y() / radius_)),
            static_cast<int>(std::floor(p.z() / radius_))};
  }

  double radius_;
  std::vector<Eigen::Vector3d> leaders_;
  std::map<std::array<int, 3>, std::vector<int>> leaders_in_;
};

/// "Share at least 95 % of scene points within them, with respect to the box with more points" (Sec. 4.1).
bool inConflict(const PointSet& a, int count_a, const PointSet& b, int count_b, double share) {
  const double needed = share * std::max(count_a, count_b);
  return std::min(count_a, count_b) >= needed && countShared(a, b) >= needed;
}

}  // namespace

std::vector<BoxHypothesis> filterBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                       const std::vector<PointOverlap>& overlaps, const FilterConfig& config) {
  Clusters clusters(config.cluster_radius_m);
  std::vector<int> members;  // per cluster: boxes looked at so far
  struct Kept {
    int cluster, points;
  };
  std::vector<Kept> kept;
  std::vector<BoxHypothesis> hypotheses;
  std::vector<int> order;  // of the hypotheses, most recent conflict first: neighbours in score are often alike
  for (const auto& scored : boxes) {
    const int cluster = clusters.assign(centreOf(scored.box, grids[scored.box.angle]));
    if (cluster == static_cast<int>(members.size())) members.push_back(0);
    if (members[cluster] == config.max_boxes_per_cluster) continue;
    ++members[cluster];
    PointSet points = overlaps[scored.box.angle].inside(scored.box);
    const int count = countPoints(points);
    if (count == 0) continue;
    const auto rival = std::find_if(order.begin(), order.end(), [&](int i) {
      return (config.across_clusters || kept[i].cluster == cluster) &&
             inConflict(points, count, hypotheses[i].points, kept[i].points, config.conflict_share);
    });
    if (rival != order.end()) {
      std::rotate(order.begin(), rival, rival + 1);
      continue;
    }
    order.insert(order.begin(), static_cast<int>(hypotheses.size()));
    hypotheses.push_back({scored, std::move(points)});
    kept.push_back({cluster, count});
  }
  return hypotheses;
}

}  // namespace objectness

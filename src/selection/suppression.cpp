// SPDX-License-Identifier: BSD-3-Clause
#include "selection/suppression.hpp"

#include <algorithm>
#include <utility>

#include "common/object_pool.hpp"
#include "common/row_bands.hpp"
#include "selection/kept_boxes.hpp"
#include "selection/leader_clusters.hpp"

namespace objectness {
namespace {

Eigen::Vector3d centreOf(const Box& box, const Grid& grid) {
  return grid.toTable({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), 0.5 * box.height});
}

LeaderClusters clustersOver(const std::vector<Grid>& grids, double radius_m) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const Grid& grid : grids) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d p = grid.toTable(
          {corner & 1 ? 1.0 * grid.nx : 0.0, corner & 2 ? 1.0 * grid.ny : 0.0, corner & 4 ? 1.0 * grid.nz : 0.0});
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {radius_m, low, high};
}

/// A copy with nothing in the groups that are not the set's.
PointBits cleared(const PointBits& points, const PointLayout& layout) {
  PointBits copy{points.groups, std::vector<std::uint64_t>(layout.words(), 0)};
  for (std::uint64_t left = points.groups; left != 0; left &= left - 1) {
    const int first = __builtin_ctzll(left) * layout.group_words;
    std::copy_n(points.words.begin() + first, layout.group_words, copy.words.begin() + first);
  }
  return copy;
}

/// What a thread has at hand while it looks at boxes.
struct Looker {
  PointBits points{0, {}};                    ///< of the box looked at
  int count = 0;                              ///< of them
  std::vector<std::vector<int>> suppressors;  ///< by cluster; of the boxes that are in none yet the first

  std::vector<int>& recent(int cluster) {
    if (cluster + 2 > static_cast<int>(suppressors.size())) suppressors.resize(cluster + 2);
    return suppressors[cluster + 1];
  }
};

/// What was kept before a batch tells of a box in it.
struct Look {
  LeaderClusters::Nearest nearest;
  bool done = false;
  bool suppressed = false;
};

class Suppression {
 public:
  Suppression(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids, const std::vector<BoxPoints>& points,
              const PointLayout& layout, const FilterConfig& config, int threads)
      : boxes_(boxes),
        grids_(grids),
        points_(points),
        layout_(layout),
        config_(config),
        threads_(threads),
        clusters_(clustersOver(grids, config.cluster_radius_m)),
        kept_(survivors_, layout, config) {}

  std::vector<SurvivingBox> run() {
    constexpr std::size_t kFirst = 64, kLargest = 8192;  // boxes a batch
    std::size_t size = kFirst;
    for (std::size_t first = 0; first < boxes_.size(); first += size, size = std::min(2 * size, kLargest)) {
      doBatch(first, std::min(size, boxes_.size() - first));
    }
    return std::move(survivors_);
  }

 private:
  static constexpr int kBoxesAtOnce = 64;

  void doBatch(std::size_t first, std::size_t size) {
    std::vector<Look> looks(size);
    forRowBands(
        static_cast<int>(size), threads_,
        [&](int begin, int end) {
          std::unique_ptr<Looker> looker = lookers_.take();
          for (int i = begin; i < end; ++i) looks[i] = look(boxes_[first + i], *looker);
          lookers_.put(std::move(looker));
        },
        kBoxesAtOnce);
    const int clusters = clusters_.count(), kept = kept_.size();
    std::unique_ptr<Looker> looker = lookers_.take();
    for (std::size_t i = 0; i < size; ++i) settle(boxes_[first + i], looks[i], clusters, kept, *looker);
    lookers_.put(std::move(looker));
  }

  Look look(const ScoredBox& scored, Looker& looker) const {
    Look seen;
    seen.nearest = clusters_.nearest(centreOf(scored.box, grids_[scored.box.angle]));
    const int cluster = seen.nearest.cluster;
    seen.done = cluster < 0 || looked_at_[cluster] < config_.max_boxes_per_cluster;
    seen.suppressed = seen.done && isSuppressed(scored, cluster, 0, looker);
    return seen;
  }

  /// clusters, kept: how many there were when it was looked at.
  void settle(const ScoredBox& scored, const Look& seen, int clusters, int kept, Looker& looker) {
    const int cluster = clusters_.assign(centreOf(scored.box, grids_[scored.box.angle]), seen.nearest, clusters);
    looked_at_.resize(clusters_.count(), 0);
    if (looked_at_[cluster] == config_.max_boxes_per_cluster) return;
    ++looked_at_[cluster];
    const bool holds = seen.done && (config_.across_clusters || cluster == seen.nearest.cluster);
    if (holds && seen.suppressed) return;
    if (isSuppressed(scored, cluster, holds ? kept : 0, looker)) return;
    survivors_.push_back({scored, cleared(looker.points, layout_)});
    kept_.add(looker.count, cluster);
  }

  bool isSuppressed(const ScoredBox& scored, int cluster, int first_kept, Looker& looker) const {
    looker.points.words.resize(layout_.words(), 0);
    looker.count = points_[scored.box.angle].inside(scored.box, 0, 0, looker.points);
    return looker.count == 0 ||
           kept_.conflictsWith(looker.points, looker.count, cluster, first_kept, looker.recent(cluster));
  }

  const std::vector<ScoredBox>& boxes_;
  const std::vector<Grid>& grids_;
  const std::vector<BoxPoints>& points_;
  const PointLayout& layout_;
  const FilterConfig& config_;
  const int threads_;
  LeaderClusters clusters_;
  std::vector<int> looked_at_;  ///< boxes, by cluster
  std::vector<SurvivingBox> survivors_;
  KeptBoxes kept_;
  ObjectPool<Looker> lookers_;
};

}  // namespace

std::vector<SurvivingBox> suppressBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                        const std::vector<BoxPoints>& points, const PointLayout& layout,
                                        const FilterConfig& config, int threads) {
  return Suppression(boxes, grids, points, layout, config, threads).run();
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/selection/point_overlap.hpp"

namespace objectness {

/// Filtering of paper Sec. 4.1.
struct FilterConfig {
  double threshold = 0.8;
  double cluster_radius_m = 0.05;
  int max_boxes_per_cluster = 500;
  double conflict_share = 0.95;
  bool across_clusters = true;
  double box_margin_m = 0.005;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("threshold", self.threshold, Range{-10, 10}, "least objectness of a box that is kept");
    visit("cluster_radius_m", self.cluster_radius_m, Range{0.001, 1},
          "boxes whose centres lie within it form a cluster");
    visit("max_boxes_per_cluster", self.max_boxes_per_cluster, Range{1, 100000},
          "n_b: the best of a cluster that are kept");
    visit("conflict_share", self.conflict_share, Range{0.01, 1},
          "boxes conflict when they share this part of the points of the one with more points");
    visit("across_clusters", self.across_clusters, "suppress conflicting boxes of different clusters, too");
    visit("box_margin_m", self.box_margin_m, Range{0, 0.05},
          "a point within this of a box counts as inside: faces are sampled coarser than points");
  }
};

/// A box that survived, with the scene points it holds.
struct BoxHypothesis {
  ScoredBox scored;
  PointSet points;
};

/// Clusters the boxes by centre (leaders are taken best first), keeps the max_boxes_per_cluster best of each, and of
/// boxes in conflict the best. boxes: sorted by better(); grids and overlaps: one per angle. Returns B*, best first.
std::vector<BoxHypothesis> filterBoxes(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                                       const std::vector<PointOverlap>& overlaps, const FilterConfig& config);

}  // namespace objectness

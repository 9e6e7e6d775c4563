// SPDX-License-Identifier: BSD-3-Clause
#include "search/footprint_scorer.hpp"

#include <algorithm>

namespace objectness {

FootprintScorer::FootprintScorer(const CueVolumes& volumes, int angle, const SearchTask& task,
                                 const std::vector<float>& top_visible)
    : volumes_(volumes),
      task_(task),
      angle_(angle),
      edges_(volumes.edges),
      filled_(volumes.filled),
      occupied_(volumes.occupied),
      tables_(superpixelTables(volumes)) {
  const ObjectnessConfig& o = task.objectness;
  constants_ = {o.weight_edges, o.weight_outer, o.weight_free, o.constant, o.max_edge_density, top_visible.data()};
  const std::size_t heights = top_visible.size();
  integers_.resize(4 * heights);
  floats_.resize(5 * heights);
  sums_.resize(heights);
  int* n = integers_.data();
  float* f = floats_.data();
  columns_ = {n,
              n + heights,
              n + 2 * heights,
              f,
              f + heights,
              f + 2 * heights,
              f + 3 * heights,
              f + 4 * heights,
              sums_.data(),
              n + 3 * heights};
}

bool FootprintScorer::passesGates(int height) const {
  const ObjectnessConfig& o = task_.objectness;
  const int occupied = columns_.occupied[height];
  const int below_top = height - std::max(height / 3, 1);
  return columns_.edges[height] >= o.min_edge_voxels && occupied >= o.min_occupied_voxels &&
         !(occupied - columns_.occupied[below_top] < o.min_top_share * occupied) &&
         !(columns_.straddling[height] < o.min_straddling);
}

int FootprintScorer::score(int x0, int x1, int y0, int y1, HeightRange heights, double threshold,
                           std::vector<ScoredBox>& boxes) {
  const Sampling& s = task_.sampling;
  const int above = (heights.first - s.min_size) % s.size_step_z;
  if (above != 0) heights.first += s.size_step_z - above;
  if (heights.first > heights.last) return 0;
  Box box{angle_, x0, x1, y0, y1, heights.last};
  int scored = 0;
  if (box.volume() > IntegralVolume::kMostCounted) {
    for (box.height = heights.first; box.height <= heights.last; box.height += s.size_step_z, ++scored) {
      const auto one = scoreBox(volumes_, box, task_.ring, task_.objectness);
      if (one && one->objectness >= threshold) boxes.push_back(*one);
    }
    return scored;
  }

  superpixels_.clear();
  for (const SuperpixelTable& superpixel : tables_) {
    if (!superpixel.meets(x0, x1, y0, y1)) continue;
    superpixels_.emplace_back();
    superpixel.corners(x0, x1, y0, y1, superpixels_.back().columns);
    superpixels_.back().total = superpixel.total;
  }
  const int r = task_.ring.xy;
  const Grid& grid = volumes_.grid;
  const Eigen::Vector3d& eye = volumes_.viewpoint;
  const bool all = task_.objectness.three_face_area;
  BoxColumns columns;
  edges_.corners(x0, x1, y0, y1, 0, columns.edges);
  edges_.corners(std::max(x0 - r, 0), std::min(x1 + r, grid.nx), std::max(y0 - r, 0), std::min(y1 + r, grid.ny),
                 task_.ring.z, columns.ring);
  filled_.corners(x0, x1, y0, y1, 0, columns.filled);
  occupied_.corners(x0, x1, y0, y1, 0, columns.occupied);
  columns.size_x = box.sizeX(), columns.size_y = box.sizeY();
  columns.side_x_visible = all || eye.x() < x0 || eye.x() > x1;
  columns.side_y_visible = all || eye.y() < y0 || eye.y() > y1;
  scoreHeights(columns, superpixels_.data(), static_cast<int>(superpixels_.size()), constants_, heights, columns_);

  for (int h = heights.first; h <= heights.last; h += s.size_step_z, ++scored) {
    if (!(columns_.objectness[h] >= threshold) || !passesGates(h)) continue;
    box.height = h;
    boxes.push_back({box,
                     {columns_.edge_density[h], columns_.outer_edges[h], columns_.straddling[h], columns_.free_space[h],
                      columns_.free_voxels[h]},
                     columns_.objectness[h]});
  }
  return scored;
}

}  // namespace objectness

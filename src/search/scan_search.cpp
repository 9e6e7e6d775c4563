// SPDX-License-Identifier: BSD-3-Clause
#include "search/scan_search.hpp"

#include <algorithm>
#include <cmath>

#include "search/column_table.hpp"
#include "search/ranking.hpp"
#include "search/scan_kernel.hpp"

namespace objectness {
namespace {

/// One angle's scan: the loops over footprints, with the kernel inside.
class Scan {
 public:
  Scan(const CueVolumes& volumes, int angle, const SearchTask& task)
      : volumes_(volumes),
        task_(task),
        s_(task.sampling),
        edges_(volumes.edges),
        filled_(volumes.filled),
        angle_(angle),
        tallest_(std::min(task.sampling.max_size, volumes.grid.nz)) {
    const ObjectnessConfig& o = task.objectness;
    constants_ = {static_cast<float>(o.weight_edges),     static_cast<float>(o.weight_outer),
                  static_cast<float>(o.weight_free),      static_cast<float>(o.constant),
                  static_cast<float>(o.max_edge_density), o.weight_outer >= 0 ? 1.0f : 0.0f,
                  static_cast<float>(o.min_edge_voxels)};
    // The kernel rounds to float: what it may lose is far below this, and scoreBox() decides anyway.
    const double scale = std::abs(o.weight_edges) * o.max_edge_density + std::abs(o.weight_outer) +
                         std::abs(o.constant) + std::abs(task.threshold) + 1;
    needed_ = static_cast<float>(task.threshold - 1e-5 * scale);
    for (int h = 0; h <= tallest_; ++h) {
      top_visible_.push_back(o.three_face_area || volumes.viewpoint.z() > h ? 1.0f : 0.0f);
    }
    bound_.resize(top_visible_.size());
  }

  SearchResult run() {
    result_.sampled = countBoxes(volumes_.grid, s_);
    if (result_.sampled == 0) return std::move(result_);
    const int nx = volumes_.grid.nx, ny = volumes_.grid.ny;
    // Edge counts grow with a box: where the largest one has too few for the gate, no smaller one is looked at.
    for (int x0 = 0; x0 + s_.min_size <= nx; x0 += s_.corner_step) {
      const int x_end = std::min(x0 + s_.max_size, nx);
      if (!enoughEdges(x0, x_end, 0, ny)) continue;
      for (int y0 = 0; y0 + s_.min_size <= ny; y0 += s_.corner_step) {
        const int y_end = std::min(y0 + s_.max_size, ny);
        if (!enoughEdges(x0, x_end, y0, y_end)) continue;
        for (int x1 = x0 + s_.min_size; x1 <= x_end; x1 += s_.size_step_xy) {
          if (!enoughEdges(x0, x1, y0, y_end)) continue;
          for (int y1 = y0 + s_.min_size; y1 <= y_end; y1 += s_.size_step_xy) {
            if (enoughEdges(x0, x1, y0, y1)) scanFootprint(x0, x1, y0, y1);
          }
        }
      }
    }
    sortBestFirst(result_.boxes);
    return std::move(result_);
  }

 private:
  bool enoughEdges(int x0, int x1, int y0, int y1) const {
    return volumes_.edges.count(x0, x1, y0, y1, tallest_) >= task_.objectness.min_edge_voxels;
  }

  void scanFootprint(int x0, int x1, int y0, int y1) {
    const int r = task_.ring.xy;
    ScanFootprint footprint;
    edges_.corners(x0, x1, y0, y1, 0, footprint.edges);
    edges_.corners(std::max(x0 - r, 0), std::min(x1 + r, volumes_.grid.nx), std::max(y0 - r, 0),
                   std::min(y1 + r, volumes_.grid.ny), task_.ring.z, footprint.ring);
    filled_.corners(x0, x1, y0, y1, 0, footprint.filled);
    footprint.base = static_cast<float>((x1 - x0) * (y1 - y0));
    const Eigen::Vector3d& eye = volumes_.viewpoint;
    const bool all = task_.objectness.three_face_area;
    footprint.sides = static_cast<float>((all || eye.x() < x0 || eye.x() > x1 ? y1 - y0 : 0) +
                                         (all || eye.y() < y0 || eye.y() > y1 ? x1 - x0 : 0));
    footprint.top_visible = top_visible_.data();
    // What may hold more than the kernel can count is scored in any case.
    const bool countable = static_cast<long>(x1 - x0) * (y1 - y0) * tallest_ <= IntegralVolume::kMostCounted;
    if (boundHeights(footprint, constants_, s_.min_size, tallest_, bound_.data()) < needed_ && countable) return;
    for (int height = s_.min_size; height <= tallest_; height += s_.size_step_z) {
      if (bound_[height - s_.min_size] < needed_ && countable) continue;
      const Box box{angle_, x0, x1, y0, y1, height};
      ++result_.scored;
      const auto scored = scoreBox(volumes_, box, task_.ring, task_.objectness);
      if (scored && scored->objectness >= task_.threshold) result_.boxes.push_back(*scored);
    }
  }

  const CueVolumes& volumes_;
  const SearchTask& task_;
  const Sampling s_;
  const ColumnTable edges_, filled_;
  const int angle_;
  const int tallest_;
  ScanConstants constants_;
  float needed_;
  std::vector<float> top_visible_, bound_;
  SearchResult result_;
};

}  // namespace

SearchResult searchScan(const CueVolumes& volumes, int angle, const SearchTask& task) {
  return Scan(volumes, angle, task).run();
}

}  // namespace objectness

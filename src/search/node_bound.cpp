// SPDX-License-Identifier: BSD-3-Clause
#include "search/node_bound.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

/// The least and largest part of a face that the viewpoint sees (visibleArea()): all of it or nothing.
void addFace(bool all, double eye, const AxisRanges& axis, int size_low, int size_high, NodeFootprint& node) {
  const bool seen_by_some = all || eye < axis.from.high || eye > axis.to.low;
  const bool seen_by_each = all || eye < axis.from.low || eye > axis.to.high;
  if (seen_by_each) node.sides_low += static_cast<float>(size_low);
  if (seen_by_some) node.sides_high += static_cast<float>(size_high);
}

}  // namespace

NodeBound::NodeBound(const CueVolumes& volumes, const SearchTask& task, const std::vector<float>& top_visible)
    : task_(task),
      nx_(volumes.grid.nx),
      ny_(volumes.grid.ny),
      viewpoint_(volumes.viewpoint),
      edges_(volumes.edges),
      filled_(volumes.filled),
      superpixels_(superpixelTables(volumes)) {
  const ObjectnessConfig& o = task.objectness;
  // The kernels round to float: what that may cost is far below this, and the leaves are scored in full anyway.
  const double scale =
      o.weight_edges * o.max_edge_density + o.weight_outer + std::abs(o.constant) + std::abs(task.threshold) + 1;
  constant_slack_ = 1e-5 * scale + o.constant;
  constants_ = {static_cast<float>(o.weight_edges),
                static_cast<float>(o.weight_outer),
                static_cast<float>(o.weight_free),
                static_cast<float>(task.threshold - constant_slack_),
                static_cast<float>(o.max_edge_density),
                static_cast<float>(1.0 / o.max_edge_density),
                static_cast<float>(o.min_edge_voxels),
                static_cast<float>(o.min_straddling),
                top_visible.data()};
  const std::size_t heights = top_visible.size();
  nothing_.resize(heights + task.ring.z, 0);
  needed_.resize(heights);
  levels_.resize(1);
  levels_[0].counts.assign(heights, 0);
  levels_[0].squares.assign(heights, 0);
  double labelled = 0;
  for (std::size_t s = 0; s < superpixels_.size(); ++s) {
    levels_[0].cut.push_back(static_cast<int>(s));
    labelled += superpixels_[s].total;
  }
  margin_slack_ = static_cast<float>(1e-3 + 1e-5 * labelled);
}

void NodeBound::raiseThreshold(double threshold) {
  constants_.needed = std::max(constants_.needed, static_cast<float>(threshold - constant_slack_));
}

HeightRange NodeBound::possible(const BoxRanges& node, int depth) {
  const HeightRange heights = needed(node);
  if (heights.first > heights.last) return heights;
  settleSuperpixels(node, depth);
  // With nothing in all of the boxes each superpixel may be in a box as a whole or not at all.
  if (node.innerEmpty()) return heights;
  const Level& sums = levels_[levels_[depth + 1].sums];
  return possibleHeights(cut_.data(), static_cast<int>(cut_.size()), sums.counts.data(), sums.squares.data(),
                         margin_slack_, heights, needed_.data());
}

HeightRange NodeBound::needed(const BoxRanges& node) {
  const AxisRanges &x = node.x, &y = node.y;
  const Sampling& s = task_.sampling;
  const int r = task_.ring.xy;
  const int ring_x0 = std::max(x.from.high - r, 0), ring_x1 = std::min(x.to.low + r, nx_);
  const int ring_y0 = std::max(y.from.high - r, 0), ring_y1 = std::min(y.to.low + r, ny_);
  NodeFootprint footprint;
  edges_.corners(x.from.low, x.to.high, y.from.low, y.to.high, 0, footprint.edges_outer);
  if (ring_x0 < ring_x1 && ring_y0 < ring_y1) {
    edges_.corners(ring_x0, ring_x1, ring_y0, ring_y1, task_.ring.z, footprint.ring_outer);
    edges_.corners(std::max(ring_x0, x.from.low), std::min(ring_x1, x.to.high), std::max(ring_y0, y.from.low),
                   std::min(ring_y1, y.to.high), 0, footprint.ring_inner);
  } else {
    footprint.ring_outer = footprint.ring_inner = nothing();
  }
  if (node.innerEmpty()) {
    footprint.filled_inner = nothing();
    footprint.inner_base = 0;
  } else {
    filled_.corners(x.from.high, x.to.low, y.from.high, y.to.low, 0, footprint.filled_inner);
    footprint.inner_base = static_cast<std::uint16_t>((x.to.low - x.from.high) * (y.to.low - y.from.high));
  }
  const int x_low = x.innerSize(s), x_high = x.outerSize(s), y_low = y.innerSize(s), y_high = y.outerSize(s);
  footprint.base_low = static_cast<float>(x_low * y_low);
  footprint.base_high = static_cast<float>(x_high * y_high);
  footprint.sides_low = footprint.sides_high = 0;
  const bool all = task_.objectness.three_face_area;
  addFace(all, viewpoint_.x(), x, y_low, y_high, footprint);
  addFace(all, viewpoint_.y(), y, x_low, x_high, footprint);
  return neededStraddling(footprint, constants_, node.heights, needed_.data());
}

void NodeBound::settleSuperpixels(const BoxRanges& node, int depth) {
  if (static_cast<int>(levels_.size()) == depth + 1) levels_.push_back(levels_[0]);
  const AxisRanges &x = node.x, &y = node.y;
  const int x_low = x.from.low, x_high = x.to.high, y_low = y.from.low, y_high = y.to.high;
  const int inner_x0 = x.from.high, inner_x1 = x.to.low, inner_y0 = y.from.high, inner_y1 = y.to.low;
  Level& here = levels_[depth + 1];
  here.cut.clear();
  here.sums = levels_[depth].sums;
  cut_.clear();
  for (const int s : levels_[depth].cut) {
    const SuperpixelTable& superpixel = superpixels_[s];
    if (!superpixel.meets(x_low, x_high, y_low, y_high)) continue;
    if (superpixel.within(inner_x0, inner_x1, inner_y0, inner_y1)) {
      addWhole(s, depth + 1);
      continue;
    }
    here.cut.push_back(s);
    cut_.emplace_back();
    CutSuperpixel& cut = cut_.back();
    superpixel.corners(x_low, x_high, y_low, y_high, cut.outer);
    if (superpixel.meets(inner_x0, inner_x1, inner_y0, inner_y1)) {
      superpixel.corners(inner_x0, inner_x1, inner_y0, inner_y1, cut.inner);
    } else {
      cut.inner = nothing();
    }
    cut.per_total = superpixel.per_total;
  }
}

void NodeBound::addWhole(int superpixel, int depth) {
  Level& level = levels_[depth];
  if (level.sums != depth) {
    level.counts = levels_[level.sums].counts;
    level.squares = levels_[level.sums].squares;
    level.sums = depth;
  }
  const SuperpixelTable& whole = superpixels_[superpixel];
  CornerColumns columns;
  whole.corners(whole.left, whole.right, whole.front, whole.back, columns);
  for (std::size_t h = 0; h < level.counts.size(); ++h) {
    const float count = columns.p11[h];
    level.counts[h] += count;
    level.squares[h] += count * count * whole.per_total;
  }
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "search/bounded_search.hpp"

#include <algorithm>
#include <numeric>

#include "search/footprint_scorer.hpp"
#include "search/node_bound.hpp"
#include "search/ranking.hpp"
#include "search/scan_search.hpp"

namespace objectness {
namespace {

/// Divides the boxes of one angle until a bound rules a part out or a single footprint is left. Heights are never
/// divided: everything is computed for all of them at once.
class BoundedSearch {
 public:
  BoundedSearch(const CueVolumes& volumes, int angle, const SearchTask& task)
      : volumes_(volumes),
        task_(task),
        s_(task.sampling),
        edges_(volumes.edges),
        top_visible_(topVisible(volumes, task)),
        bound_(volumes, task, top_visible_),
        scorer_(volumes, angle, task, top_visible_) {}

  SearchResult run() {
    result_.sampled = countBoxes(volumes_.grid, s_);
    if (result_.sampled == 0) return std::move(result_);
    BoxRanges all{
        allFaces(volumes_.grid.nx), allFaces(volumes_.grid.ny), {s_.min_size, std::min(s_.max_size, volumes_.grid.nz)}};
    visit(all, 0);
    sortBestFirst(result_.boxes);
    return std::move(result_);
  }

 private:
  static std::vector<float> topVisible(const CueVolumes& volumes, const SearchTask& task) {
    std::vector<float> visible;
    const int tallest = std::min(task.sampling.max_size, volumes.grid.nz);
    for (int h = 0; h <= tallest + IntegralVolume::kPadding; ++h) {
      visible.push_back(task.objectness.three_face_area || volumes.viewpoint.z() > h ? 1.0f : 0.0f);
    }
    return visible;
  }

  AxisRanges allFaces(int extent) const {
    // The far faces lie on a lattice of their own only if the two steps have one in common; the leaves check the sizes.
    const int step = std::gcd(s_.corner_step, s_.size_step_xy);
    AxisRanges axis;
    axis.from = {0, (extent - s_.min_size) / s_.corner_step * s_.corner_step, s_.corner_step};
    axis.to = {s_.min_size, s_.min_size + (extent - s_.min_size) / step * step, step};
    return axis;
  }

  void visit(BoxRanges node, int depth) {
    if (!node.x.tighten(s_) || !node.y.tighten(s_)) return;
    ++result_.nodes;
    if (task_.running != nullptr) bound_.raiseThreshold(task_.running->value());
    node.heights = bound_.possible(node, depth);
    if (node.heights.first > node.heights.last) return;
    if (node.single()) {
      score(node);
      return;
    }
    FaceRange* face = nullptr;
    const int cut = chooseCut(node, face);
    const FaceRange whole = *face;
    face->high = cut;
    visit(node, depth + 1);
    face->low = cut + whole.step;
    face->high = whole.high;
    visit(node, depth + 1);
  }

  void score(const BoxRanges& node) {
    const int x0 = node.x.from.low, x1 = node.x.to.low, y0 = node.y.from.low, y1 = node.y.to.low;
    if ((x1 - x0 - s_.min_size) % s_.size_step_xy != 0 || (y1 - y0 - s_.min_size) % s_.size_step_xy != 0) return;
    const double threshold = task_.running ? std::max(task_.threshold, task_.running->value()) : task_.threshold;
    const std::size_t before = result_.boxes.size();
    result_.scored += scorer_.score(x0, x1, y0, y1, node.heights, threshold, result_.boxes);
    if (task_.running == nullptr) return;
    for (std::size_t i = before; i < result_.boxes.size(); ++i) task_.running->add(result_.boxes[i].objectness);
  }

  /// The face to divide and the last position of its lower half: where most edge voxels depend on it, in their middle.
  int chooseCut(BoxRanges& node, FaceRange*& face) const {
    const int height = node.heights.last;
    const AxisRanges &x = node.x, &y = node.y;
    const auto inX = [&](int x0, int x1) { return edges_.count(x0, x1, y.from.low, y.to.high, height); };
    const auto inY = [&](int y0, int y1) { return edges_.count(x.from.low, x.to.high, y0, y1, height); };
    int most = 0;
    bool along_x = true;
    const auto consider = [&](FaceRange& candidate, bool is_x) {
      if (candidate.single()) return;
      const int edges = is_x ? inX(candidate.low, candidate.high) : inY(candidate.low, candidate.high);
      if (face != nullptr && (edges < most || (edges == most && candidate.count() <= face->count()))) return;
      face = &candidate, most = edges, along_x = is_x;
    };
    consider(node.x.from, true);
    consider(node.x.to, true);
    consider(node.y.from, false);
    consider(node.y.to, false);

    const int middle = face->low + (face->count() - 1) / 2 * face->step;
    if (most == 0) return middle;
    int low = face->low, high = face->high;  // half of the edges lie between `low` and a position up to `high`
    while (high - low > face->step) {
      const int position = low + (high - low) / (2 * face->step) * face->step;
      const int below = along_x ? inX(face->low, position) : inY(face->low, position);
      (2 * below < most ? low : high) = position;
    }
    const int cut = (2 * low + middle) / 3;
    return std::clamp(face->low + (cut - face->low) / face->step * face->step, face->low, face->high - face->step);
  }

  const CueVolumes& volumes_;
  const SearchTask& task_;
  const Sampling s_;
  const ColumnTable edges_;
  const std::vector<float> top_visible_;
  NodeBound bound_;
  FootprintScorer scorer_;
  SearchResult result_;
};

/// The bounds hold for these weights, and the kernels count edges and superpixels modulo 2^16.
std::string whyUnbounded(const CueVolumes& volumes, const ObjectnessConfig& objectness) {
  if (objectness.weight_edges < 0 || objectness.weight_outer < 0 || objectness.weight_free > 0) {
    return "the bounds of the search hold for weight_edges and weight_outer >= 0 and weight_free <= 0";
  }
  const auto fits = [](int total) { return total <= IntegralVolume::kMostCounted; };
  if (!fits(volumes.edges.total())) return "the volume holds more edge voxels than the bounds can count";
  for (const SuperpixelVolume& superpixel : volumes.superpixels) {
    if (!fits(superpixel.total())) return "a superpixel has more voxels than the bounds can count";
  }
  return "";
}

}  // namespace

SearchResult searchBounded(const CueVolumes& volumes, int angle, const SearchTask& task) {
  const std::string reason = whyUnbounded(volumes, task.objectness);
  if (reason.empty()) return BoundedSearch(volumes, angle, task).run();
  SearchResult result = searchScan(volumes, angle, task);
  result.unbounded = reason;
  return result;
}

}  // namespace objectness

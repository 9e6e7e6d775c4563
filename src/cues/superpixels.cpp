// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/superpixels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "crease.hpp"
#include "grown_pieces.hpp"

namespace objectness {
namespace {

constexpr double kResidualFloor = 0.0012;  // metres; whole millimetres of depth leave about this much on any plane
constexpr int kTableStride = 5;            // every so many pixels are plenty for a median

/// Median over the table of a length per z^2: it holds the noise of this sensor in this frame.
template <class Length>
double tableMedian(const Frame& frame, const Normals& normals, const ObjectPoints& object_points, Length&& length_m) {
  std::vector<float> lengths;
  for (int i = 0; i < frame.size(); i += kTableStride) {
    const float z = frame.points[i].z();
    if (object_points.on_table(i) && normals.radius_px[i] > 0) lengths.push_back(length_m(i) / (z * z));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + lengths.size() / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Object points whose window is one smooth piece of surface: not fitted badly, not bent, no step.
cv::Mat_<uchar> smoothPixels(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                             const SuperpixelsConfig& config) {
  const auto residual = [&](int i) { return normals.residual_m[i]; };
  const bool steps = std::isfinite(config.min_step_m);  // superpixelsForBoxes() has none: no time for them either
  const auto step = [&](const cv::Mat_<uchar>& where, int i) {
    return !steps ? 0.f : stepAt(frame, normals, where, i % frame.width(), i / frame.width());
  };
  const double max_residual = config.max_residuals * tableMedian(frame, normals, object_points, residual);
  const double max_step = config.max_steps * tableMedian(frame, normals, object_points,
                                                         [&](int i) { return step(object_points.on_table, i); });
  const double max_concave = bendOf(config.concave_deg), max_convex = bendOf(config.convex_deg);
  const BendMap bends = findBends(frame, normals, object_points.mask);
  cv::Mat_<uchar> smooth(frame.height(), frame.width(), uchar(0));
  for (int i = 0; i < frame.size(); ++i) {
    if (!object_points.mask(i) || normals.radius_px[i] < kMinWindowPx) continue;
    const double z = frame.points[i].z();
    const bool cut = residual(i) > std::max(kResidualFloor, max_residual * z * z) || bends.concave(i) > max_concave ||
                     bends.convex(i) > max_convex ||
                     step(object_points.mask, i) > std::max(config.min_step_m, max_step * z * z);
    smooth(i) = cut ? 0 : 255;
  }
  return smooth;
}

}  // namespace

SuperpixelsConfig superpixelsForBoxes(SuperpixelsConfig config) {
  config.min_step_m = std::numeric_limits<double>::infinity();
  config.narrow_share = 0;
  return config;
}

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config) {
  Superpixels superpixels{cv::Mat_<int>::zeros(frame.height(), frame.width()), 0};
  const std::vector<int> pieces =
      growPieces(frame, normals, table.noise, smoothPixels(frame, normals, object_points, config), config);
  std::vector<int> label(frame.size(), 0);  // of a piece
  for (int i = 0; i < frame.size(); ++i) {
    if (pieces[i] < 0) continue;
    int& own = label[pieces[i]];
    if (own == 0) own = ++superpixels.count;
    superpixels.label(i) = own;
  }
  return superpixels;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/superpixels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/row_bands.hpp"
#include "common/upper_median.hpp"
#include "cues/cue_steps.hpp"
#include "cues/watershed.hpp"
#include "scene/sampled_values.hpp"

namespace objectness {
namespace {

constexpr double kResidualFloor = 0.0012;  // metres; whole millimetres of depth leave about this much on any plane
// Every so many pixels are plenty for a median. Coprime to the width of pictures: not the same columns in every row.
constexpr int kResidualStride = 5, kStepStride = 17;

/// Median over the table of a length per z^2: it holds the noise of this sensor in this frame.
template <class Length>
double tableMedian(const Frame& frame, const Normals& normals, const ObjectPoints& object_points, int stride,
                   int threads, Length&& length_m) {
  std::vector<float> all = sampledValues(frame.size(), stride, threads, [&](int i, std::vector<float>& lengths) {
    const float z = frame.points[i].z();
    if (object_points.on_table(i) && normals.radius_px[i] > 0) lengths.push_back(length_m(i) / (z * z));
  });
  if (all.empty()) return 0;
  return upperMedian(all);
}

}  // namespace

cv::Mat_<uchar> smoothPixels(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                             const BendMap& bends, const SuperpixelsConfig& config, int threads) {
  const auto residual = [&](int i) { return normals.residual_m[i]; };
  const bool steps = std::isfinite(config.min_step_m);  // superpixelsForBoxes() has none: no time for them either
  const auto tableStep = [&](int i) {
    return !steps ? 0.f : stepAt(frame, normals, object_points.on_table, i % frame.width(), i / frame.width());
  };
  const double max_residual =
      config.max_residuals * tableMedian(frame, normals, object_points, kResidualStride, threads, residual);
  const double max_step =
      config.max_steps * tableMedian(frame, normals, object_points, kStepStride, threads, tableStep);
  const double max_concave = bendOf(config.concave_deg), max_convex = bendOf(config.convex_deg);
  cv::Mat_<uchar> smooth(frame.height(), frame.width());
  cv::Mat_<float> step(smooth.size());
  const auto isSmooth = [&](int i) {
    if (!object_points.mask(i) || normals.radius_px[i] < kMinWindowPx) return false;
    const double z = frame.points[i].z();
    return !(residual(i) > std::max(kResidualFloor, max_residual * z * z) || bends.concave(i) > max_concave ||
             bends.convex(i) > max_convex || (steps && step(i) > std::max(config.min_step_m, max_step * z * z)));
  };
  forRowBands(frame.height(), threads, [&](int first, int last) {
    if (steps) findStepsInRows(frame, normals, object_points.mask, first, last, step);
    for (int i = first * frame.width(); i < last * frame.width(); ++i) smooth(i) = isSmooth(i) ? 255 : 0;
  });
  return smooth;
}

SuperpixelsConfig superpixelsForBoxes(SuperpixelsConfig config) {
  config.min_step_m = std::numeric_limits<double>::infinity();
  config.narrow_share = 0;
  return config;
}

Superpixels growSuperpixels(const Frame& frame, const SmoothSurface& surface, const SuperpixelsConfig& config) {
  Superpixels superpixels{growRegions(frame, surface, config), 0};
  for (int i = 0; i < frame.size(); ++i) {
    int& label = superpixels.label(i);
    if (label < 0) {
      label = 0;
    } else {
      label = label == i ? ++superpixels.count : superpixels.label(label);  // its first pixel names a piece
    }
  }
  return superpixels;
}

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config, int threads) {
  const BendMap bends = findBends(frame, normals, object_points.mask, threads);
  const cv::Mat_<uchar> smooth = smoothPixels(frame, normals, object_points, bends, config, threads);
  return growSuperpixels(frame, connectSmooth(frame, normals, table.noise, smooth, config, threads), config);
}

}  // namespace objectness

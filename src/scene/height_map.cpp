// SPDX-License-Identifier: BSD-3-Clause
#include "scene/height_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "common/row_bands.hpp"
#include "scene/connected_components_2d.hpp"
#include "scene/height_kernel.hpp"
#include "scene/surface_samples.hpp"

namespace objectness {
namespace {

constexpr float kLowShare = 0.6f;  // of the threshold, for pixels next to certain ones
constexpr int kLowReachPx = 3;
constexpr int kMinSeedPixels = 40;  // smaller specks over the threshold are noise

HeightRule heightRule(const Table& table, const ObjectPointsConfig& config) {
  const FastPlane plane(table);
  const Eigen::Matrix<float, 2, 3> axes = table.T_table_camera.linear().topRows<2>().cast<float>();
  const float low = static_cast<float>(config.min_threshold_m);
  HeightRule rule;
  std::copy_n(plane.normal.data(), 3, rule.normal);
  rule.d = plane.d;
  for (int k = 0; k < 3; ++k) rule.x_axis[k] = axes(0, k), rule.y_axis[k] = axes(1, k);
  rule.x_origin = static_cast<float>(table.extent.origin.x());
  rule.y_origin = static_cast<float>(table.extent.origin.y());
  rule.inverse_cell = static_cast<float>(1 / table.extent.cell_m);
  rule.columns = table.extent.cells.cols;
  rule.rows = table.extent.cells.rows;
  rule.sigmas = static_cast<float>(config.noise_sigmas);
  rule.low = low;
  rule.high = std::max(low, static_cast<float>(config.max_threshold_m));
  rule.constant = static_cast<float>(table.noise.constant_m);
  rule.quadratic = static_cast<float>(table.noise.quadratic_per_m);
  return rule;
}

/// An opening with 2 x 2 pixels; cv::morphologyEx would shift it by one.
void openByTwo(cv::Mat_<uchar>& mask) {
  cv::erode(mask, mask, cv::Mat::ones(2, 2, CV_8U), cv::Point(0, 0));
  cv::dilate(mask, mask, cv::Mat::ones(2, 2, CV_8U), cv::Point(1, 1));
}

void clearSmallParts(cv::Mat_<uchar>& mask, int min_pixels) {
  const MaskComponents parts = findComponents(mask, Neighbours::kEight);
  std::vector<int> pixels(parts.count, 0);
  for (const Run& run : parts.runs) pixels[run.part] += run.last - run.first;
  for (const Run& run : parts.runs) {
    if (pixels[run.part] < min_pixels) std::fill(&mask(run.row, run.first), mask[run.row] + run.last, uchar(0));
  }
}

}  // namespace

HeightMap makeHeightMap(const Frame& frame, const Table& table, const ObjectPointsConfig& config, int threads) {
  const int width = frame.width(), height = frame.height();
  HeightMap map{cv::Mat_<float>(height, width), cv::Mat_<float>(height, width), cv::Mat_<uchar>(height, width), {}};
  const HeightRule rule = heightRule(table, config);
  const uchar* cells = table.extent.cells.ptr();
  const bool any_beyond = cv::countNonZero(table.extent.cells == TableExtent::kBeyond) > 0;
  if (any_beyond) map.beyond.create(height, width);
  CV_Assert(table.extent.cells.empty() || table.extent.cells.isContinuous());
  forRowBands(height, threads, [&](int first, int last) {
    std::vector<int> cell(width);
    for (int v = first; v < last; ++v) {
      const float* points = frame.points[std::size_t(v) * width].data();
      measureHeights(points, width, rule, map.height_m[v], map.threshold_m[v], cell.data());
      for (int u = 0; u < width; ++u) {
        const uchar value = cell[u] < 0 ? uchar(0) : cells[cell[u]];
        map.inside(v, u) = value >= TableExtent::kMargin ? 255 : 0;
        if (any_beyond) map.beyond(v, u) = value == TableExtent::kBeyond ? 255 : 0;
      }
    }
  });
  return map;
}

cv::Mat_<uchar> aboveTable(const HeightMap& map) {
  cv::Mat_<uchar> seeds = map.height_m > map.threshold_m;  // false for NaN
  openByTwo(seeds);
  clearSmallParts(seeds, kMinSeedPixels);
  const cv::Mat disk = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * kLowReachPx + 1, 2 * kLowReachPx + 1));
  cv::Mat_<uchar> near;
  cv::dilate(seeds, near, disk);
  const cv::Mat_<uchar> low = map.height_m > kLowShare * map.threshold_m;
  return seeds | (near & low);
}

}  // namespace objectness

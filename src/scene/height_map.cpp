// SPDX-License-Identifier: BSD-3-Clause
#include "height_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "surface_samples.hpp"

namespace objectness {
namespace {

constexpr float kLowShare = 0.6f;  // of the threshold, for pixels next to certain ones
constexpr int kLowReachPx = 3;
constexpr int kMinSeedPixels = 40;  // smaller specks over the threshold are noise

}  // namespace

HeightMap makeHeightMap(const Frame& frame, const Table& table, const ObjectPointsConfig& config) {
  const int width = frame.width(), height = frame.height();
  HeightMap map{cv::Mat_<float>(height, width), cv::Mat_<float>(height, width),
                cv::Mat_<uchar>(height, width, uchar(0))};
  const FastPlane plane(table);
  const Eigen::Matrix<float, 2, 3> axes = table.T_table_camera.linear().topRows<2>().cast<float>();
  const float inverse_cell = static_cast<float>(1 / table.extent.cell_m);
  const Eigen::Vector2f origin = table.extent.origin.cast<float>();
  const cv::Mat_<uchar>& cells = table.extent.cells;
  const float sigmas = static_cast<float>(config.noise_sigmas);
  const float low = static_cast<float>(config.min_threshold_m);
  const float high = std::max(low, static_cast<float>(config.max_threshold_m));
  const float constant = static_cast<float>(table.noise.constant_m);
  const float quadratic = static_cast<float>(table.noise.quadratic_per_m);
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      const Eigen::Vector3f& p = frame.points[i];
      const float h = plane.height(p);
      map.height_m(v, u) = h;
      if (!(p.z() > 0)) {
        map.threshold_m(v, u) = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      // Depth noise moves a point along its ray: seen at a grazing angle, little of it is height.
      const float cosine = std::abs((h - plane.d) / p.z());
      map.threshold_m(v, u) = std::min(high, std::max(low, sigmas * (constant + quadratic * p.z() * p.z()) * cosine));
      const Eigen::Vector2f cell = (axes * p - origin) * inverse_cell;
      if (cell.x() >= 0 && cell.y() >= 0 && cell.x() < cells.cols && cell.y() < cells.rows) {
        map.inside(v, u) = cells(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
      }
    }
  }
  return map;
}

cv::Mat_<uchar> aboveTable(const HeightMap& map) {
  cv::Mat_<uchar> seeds = map.height_m > map.threshold_m;  // false for NaN
  // An opening with 2 x 2 pixels; cv::morphologyEx would shift it by one.
  cv::erode(seeds, seeds, cv::Mat::ones(2, 2, CV_8U), cv::Point(0, 0));
  cv::dilate(seeds, seeds, cv::Mat::ones(2, 2, CV_8U), cv::Point(1, 1));
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(seeds, labels, stats, centroids, 8);
  std::vector<uchar> keep(count, 0);
  for (int i = 1; i < count; ++i) keep[i] = stats.at<int>(i, cv::CC_STAT_AREA) >= kMinSeedPixels ? 255 : 0;
  std::transform(labels.begin<int>(), labels.end<int>(), seeds.begin(), [&](int label) { return keep[label]; });

  const cv::Mat disk = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * kLowReachPx + 1, 2 * kLowReachPx + 1));
  cv::Mat_<uchar> near;
  cv::dilate(seeds, near, disk);
  const cv::Mat_<uchar> low = map.height_m > kLowShare * map.threshold_m;
  return seeds | (near & low);
}

}  // namespace objectness

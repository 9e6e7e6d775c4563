// SPDX-License-Identifier: BSD-3-Clause
#include "plane_grid.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr double kMaxReachM = 4.0;     // of a table from its middle; keeps the grid of a hall's floor small
constexpr double kBridgedGapM = 0.025;  // missing depth within the surface
constexpr double kSpeckM = 0.015;       // points that only happen to be at table height
constexpr double kBridgedShadowM = 0.16;
constexpr float kMinNormalCosine = 0.9063f;  // 25 deg
constexpr float kBehindM = 0.015f;      // beyond the tolerance: further behind the plane than any dent of a table
constexpr double kMarginM = 0.06;       // empty rim, room for the extent to be dilated

/// Structuring element that reaches length_m / 2 to each side.
cv::Mat square(double length_m, double cell_m) {
  const int reach = std::max(1, static_cast<int>(std::lround(length_m / cell_m / 2)));
  return cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
}

cv::Mat_<uchar> largestPart(const cv::Mat_<uchar>& cells) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(cells, labels, stats, centroids, 4);
  int best = 0, best_area = 0;
  for (int i = 1; i < count; ++i) {
    const int area = stats.at<int>(i, cv::CC_STAT_AREA);
    if (area > best_area) best_area = area, best = i;
  }
  if (best == 0) return cv::Mat_<uchar>(cells.size(), uchar(0));
  return cv::Mat_<uchar>(labels == best);
}

cv::Mat_<uchar> fillHoles(const cv::Mat_<uchar>& cells) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(cells.clone(), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat_<uchar> filled(cells.size(), uchar(0));
  cv::drawContours(filled, contours, -1, cv::Scalar(255), cv::FILLED);
  return filled;
}

}  // namespace

Eigen::Isometry3d tableFrame(const Plane& plane) {
  const Eigen::Vector3d z = plane.normal;
  // A plane seen from the side has the camera's x axis along its normal: then the y axis is the one to lay down.
  const Eigen::Vector3d along = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d x = (along - along.dot(z) * z).normalized();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear().row(0) = x;
  T.linear().row(1) = z.cross(x);
  T.linear().row(2) = z;
  T.translation() = Eigen::Vector3d(0, 0, plane.d);
  return T;
}

bool PlaneGrid::cell(double x, double y, cv::Point& result) const {
  result.x = static_cast<int>(std::floor((x - origin.x()) / cell_m));
  result.y = static_cast<int>(std::floor((y - origin.y()) / cell_m));
  return result.x >= 0 && result.y >= 0 && result.x < on_plane.cols && result.y < on_plane.rows;
}

PlaneGrid makePlaneGrid(const SurfaceSamples& samples, const Plane& plane, double cell_m) {
  PlaneGrid grid;
  grid.T_table_camera = tableFrame(plane);
  grid.cell_m = cell_m;
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = grid.T_table_camera.linear().topRows<2>().cast<float>();

  std::vector<Eigen::Vector2f> on_plane;
  for (const auto& sample : samples.samples) {
    if (!sample.valid() || std::abs(fast.height(sample.point)) > sample.tolerance()) continue;
    if (sample.hasNormal() && sample.normal.dot(fast.normal) < kMinNormalCosine) continue;
    on_plane.push_back(axes * sample.point);
  }
  grid.samples_on_plane = static_cast<int>(on_plane.size());
  if (on_plane.empty()) return grid;

  std::vector<float> x, y;
  for (const auto& p : on_plane) x.push_back(p.x()), y.push_back(p.y());
  std::nth_element(x.begin(), x.begin() + x.size() / 2, x.end());
  std::nth_element(y.begin(), y.begin() + y.size() / 2, y.end());
  const Eigen::Vector2d middle(x[x.size() / 2], y[y.size() / 2]);
  Eigen::Vector2d low = middle, high = middle;
  for (const auto& p : on_plane) {
    low = low.cwiseMin(p.cast<double>());
    high = high.cwiseMax(p.cast<double>());
  }
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(kMaxReachM);
  low = low.cwiseMax(middle - reach) - Eigen::Vector2d::Constant(kMarginM);
  high = high.cwiseMin(middle + reach) + Eigen::Vector2d::Constant(kMarginM);
  grid.origin = low;
  const int columns = static_cast<int>(std::ceil((high.x() - low.x()) / cell_m));
  const int rows = static_cast<int>(std::ceil((high.y() - low.y()) / cell_m));
  grid.on_plane = cv::Mat_<uchar>(rows, columns, uchar(0));
  grid.seen_through = cv::Mat_<uchar>(rows, columns, uchar(0));

  cv::Point cell;
  for (const auto& p : on_plane) {
    if (grid.cell(p.x(), p.y(), cell)) grid.on_plane(cell) = 255;
  }
  for (const auto& sample : samples.samples) {
    if (!sample.valid()) continue;
    const float height = fast.height(sample.point);
    if (height >= -(sample.tolerance() + kBehindM)) continue;
    const float scale = fast.d / (fast.d - height);  // the ray from the camera (at height d) crosses height 0 here
    const Eigen::Vector2f crossing = axes * sample.point * scale;
    if (grid.cell(crossing.x(), crossing.y(), cell) && grid.on_plane(cell) == 0) grid.seen_through(cell) = 255;
  }
  return grid;
}

cv::Mat_<uchar> extentOf(const PlaneGrid& grid) {
  cv::Mat_<uchar> solid, bridged;
  cv::morphologyEx(grid.on_plane, solid, cv::MORPH_CLOSE, square(kBridgedGapM, grid.cell_m));
  cv::morphologyEx(solid, solid, cv::MORPH_OPEN, square(kSpeckM, grid.cell_m));
  // Without a frame of empty cells the closing would stick the border of the grid to the table.
  const int pad = static_cast<int>(std::ceil(kBridgedShadowM / grid.cell_m));
  cv::Mat padded;
  cv::copyMakeBorder(solid, padded, pad, pad, pad, pad, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::morphologyEx(padded, padded, cv::MORPH_CLOSE, square(kBridgedShadowM, grid.cell_m));
  bridged = padded(cv::Rect(pad, pad, solid.cols, solid.rows)).clone();
  bridged.setTo(0, grid.seen_through);
  return fillHoles(largestPart(bridged));
}

}  // namespace objectness

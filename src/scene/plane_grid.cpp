// SPDX-License-Identifier: BSD-3-Clause
#include "plane_grid.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace objectness {
namespace {

constexpr double kMaxReachM = 4.0;       // of a table from its middle; keeps the grid of a hall's floor small
constexpr double kBridgedGapM = 0.025;   // missing depth within the surface
constexpr double kSpeckM = 0.015;        // points that only happen to be at table height
constexpr double kMinPartM2 = 0.0025;    // of the surface seen between things; smaller ones are not part of it
constexpr double kBridgedThingM = 0.32;  // between parts of the surface, under a thing or its shadow
constexpr double kReachM = 0.16;         // how far the table goes on under things beyond the last of it that is seen
constexpr double kRimM = 0.05;           // things stand at the very edge, and table edges are rounded
constexpr float kMinNormalCosine = 0.9063f;  // 25 deg
constexpr float kBehindM = 0.015f;           // beyond the tolerance: further behind the plane than any dent of a table
constexpr float kCoverCeilingM = 0.45f;      // higher things rather stand behind the table

/// Structuring element that reaches this far to each side.
cv::Mat square(double reach_m, double cell_m) {
  const int reach = std::max(1, static_cast<int>(std::lround(reach_m / cell_m)));
  return cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
}

cv::Mat_<uchar> withoutSmallParts(const cv::Mat_<uchar>& cells, double min_cells) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(cells, labels, stats, centroids, 8);
  std::vector<uchar> keep(count, 0);
  for (int i = 1; i < count; ++i) keep[i] = stats.at<int>(i, cv::CC_STAT_AREA) >= min_cells ? 255 : 0;
  cv::Mat_<uchar> result(cells.size());
  std::transform(labels.begin<int>(), labels.end<int>(), result.begin(), [&](int label) { return keep[label]; });
  return result;
}

/// The connected part of `cells` that holds most of `counted`.
cv::Mat_<uchar> mainPart(const cv::Mat_<uchar>& cells, const cv::Mat_<uchar>& counted) {
  cv::Mat labels;
  std::vector<int> counts(cv::connectedComponents(cells, labels, 4, CV_32S), 0);
  for (std::size_t i = 0; i < cells.total(); ++i) {
    if (cells.data[i] && counted.data[i]) ++counts[labels.ptr<int>()[i]];
  }
  const auto best = std::max_element(counts.begin(), counts.end());
  if (*best == 0) return cv::Mat_<uchar>(cells.size(), uchar(0));
  return cv::Mat_<uchar>(labels == static_cast<int>(best - counts.begin()));
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

PlaneGrid makePlaneGrid(const SurfaceSamples& samples, const Plane& plane, double cell_m) {
  PlaneGrid grid;
  grid.T_table_camera = tableFrame(plane);
  grid.cell_m = cell_m;
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = grid.T_table_camera.linear().topRows<2>().cast<float>();

  std::vector<Eigen::Vector2f> on_plane;
  on_plane.reserve(samples.samples.size());
  for (const auto& sample : samples.samples) {
    if (!sample.valid() || std::abs(fast.height(sample.point)) > sample.tolerance()) continue;
    if (sample.hasNormal() && sample.normal.dot(fast.normal) < kMinNormalCosine) continue;
    on_plane.push_back(axes * sample.point);
  }
  grid.samples_on_plane = static_cast<int>(on_plane.size());
  if (on_plane.empty()) return grid;

  std::vector<float> x, y;
  x.reserve(on_plane.size());
  y.reserve(on_plane.size());
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
  low = low.cwiseMax(middle - reach) - Eigen::Vector2d::Constant(kReachM);
  high = high.cwiseMin(middle + reach) + Eigen::Vector2d::Constant(kReachM);
  grid.origin = low;
  const int columns = static_cast<int>(std::ceil((high.x() - low.x()) / cell_m));
  const int rows = static_cast<int>(std::ceil((high.y() - low.y()) / cell_m));
  grid.on_plane = cv::Mat_<uchar>(rows, columns, uchar(0));
  grid.seen_through = cv::Mat_<uchar>(rows, columns, uchar(0));
  grid.covered = cv::Mat_<uchar>(rows, columns, uchar(0));

  cv::Point cell;
  for (const auto& p : on_plane) {
    if (grid.cell(p.x(), p.y(), cell)) grid.on_plane(cell) = 255;
  }
  for (const auto& sample : samples.samples) {
    if (!sample.valid()) continue;
    const float height = fast.height(sample.point);
    const bool behind = height < -(sample.tolerance() + kBehindM);
    const bool over = height > sample.tolerance() && height < kCoverCeilingM;
    if (!behind && !over) continue;  // most of a view
    const Eigen::Vector2f foot = axes * sample.point;
    const float scale = fast.d / (fast.d - height);  // the ray from the camera (at height d) crosses height 0 here
    const bool crosses = scale > 0 && grid.cell(foot.x() * scale, foot.y() * scale, cell);
    if (behind) {
      if (crosses && grid.on_plane(cell) == 0) grid.seen_through(cell) = 255;
    } else {
      if (crosses) grid.covered(cell) = 255;
      if (grid.cell(foot.x(), foot.y(), cell)) grid.covered(cell) = 255;
    }
  }
  return grid;
}

cv::Mat_<uchar> extentOf(const PlaneGrid& grid) {
  cv::Mat_<uchar> solid;
  cv::morphologyEx(grid.on_plane, solid, cv::MORPH_CLOSE, square(kBridgedGapM / 2, grid.cell_m));
  cv::morphologyEx(solid, solid, cv::MORPH_OPEN, square(kSpeckM / 2, grid.cell_m));
  solid = withoutSmallParts(solid, kMinPartM2 / (grid.cell_m * grid.cell_m));

  // Bridge what things cover. The grid has an empty rim as wide as the reach, so that its border sticks to nothing.
  cv::Mat_<uchar> core, rim, reachable;
  cv::morphologyEx(solid, core, cv::MORPH_CLOSE, square(kBridgedThingM / 2, grid.cell_m));
  core = solid | (core & grid.covered);
  cv::morphologyEx(core, core, cv::MORPH_CLOSE, square(kBridgedGapM / 2, grid.cell_m));
  core.setTo(0, grid.seen_through);
  core = fillHoles(mainPart(core, solid));

  const int rim_cells = std::max(1, static_cast<int>(std::lround(kRimM / grid.cell_m)));
  cv::dilate(core, rim, cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * rim_cells + 1, 2 * rim_cells + 1)));
  cv::dilate(core, reachable, square(kReachM, grid.cell_m));
  cv::Mat_<uchar> all = rim | (reachable & grid.covered);
  all.setTo(0, grid.seen_through);
  cv::Mat_<uchar> extent = fillHoles(mainPart(all | core, core)) & kMargin;
  extent.setTo(kCore, core);
  return extent;
}

}  // namespace objectness

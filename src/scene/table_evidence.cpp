// SPDX-License-Identifier: BSD-3-Clause
#include "scene/table_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "common/upper_median.hpp"
#include "scene/connected_components_3d.hpp"
#include "scene/foot_height.hpp"

namespace objectness {
namespace {

constexpr double kCellM = 0.02;
constexpr float kCeilingM = 0.45f;  // what reaches higher is rather a wall, a shelf or a robot
constexpr float kUnderM = 0.35f;    // what lies deeper under a table is the floor
constexpr int kMinFootSamples = 3;
constexpr int kMinGroup = 6;
constexpr int kBorderSamples = 2;
constexpr double kLeaves = 0.5;    // samples at the picture's border, of the square root of all
constexpr double kMaxOutside = 1;  // samples beside the plane per sample over it
constexpr float kGapM = 0.015f;
constexpr double kGapPixels = 3;  // of z / f, per sample
constexpr float kGapSigmas = 4;
constexpr double kUnlikely = 0.2;  // weight of groups that are too high or too wide
constexpr double kLeaving = 0.5;   // of those that leave the picture: an arm, or a thing that is cut off
constexpr double kNormalView = 40000.0;

constexpr double kNearM = 1.3, kFarM = 3.3;  // full weight of a table up to here, next to none from there
constexpr double kMinDistanceWeight = 0.05;
constexpr double kFullAreaM2 = 0.08;
constexpr double kEnoughInliers = 1500;
constexpr double kBelowWeight = 3.0;
constexpr double kHiddenReachM = 0.14;  // of what counts as hidden, from what is seen
constexpr double kMinUnderM = 0.1;
constexpr double kUnderCosine = 0.9744;  // 13 deg: small planes far apart

/// A connected group of samples over the plane; most numbers are of those over the extent.
struct Group {
  int count = 0, foot = 0, too_high = 0;
  int outside = 0;
  int at_border = 0;  ///< of all, at the picture's
  Eigen::Vector2f low = Eigen::Vector2f::Constant(1e9f), high = Eigen::Vector2f::Constant(-1e9f);
};

double scaleOf(const SurfaceSamples& view) { return kNormalView / std::max<std::size_t>(1, view.samples.size()); }

}  // namespace

SeenPlane seePlane(const SurfaceSamples& view, const Plane& plane) {
  SeenPlane seen;
  seen.grid = makePlaneGrid(view, plane, kCellM);
  if (seen.grid.empty()) return seen;
  seen.core = extentOf(seen.grid) == TableExtent::kCore;
  const double cell_area = kCellM * kCellM;
  TableEvidence& evidence = seen.evidence;
  evidence.area_m2 = cv::countNonZero(seen.core) * cell_area;
  evidence.seen_m2 = cv::countNonZero(seen.grid.on_plane & seen.core) * cell_area;
  const int reach = static_cast<int>(kHiddenReachM / kCellM);
  cv::Mat_<uchar> hidden;
  cv::dilate(seen.core, hidden, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));
  hidden.setTo(0, seen.grid.on_plane | seen.grid.seen_through);
  evidence.hidden_m2 = cv::countNonZero(hidden) * cell_area;
  const cv::Moments moments = cv::moments(seen.core, true);
  if (moments.m00 > 0) {
    const Eigen::Vector2d cell(moments.m10 / moments.m00 + 0.5, moments.m01 / moments.m00 + 0.5);
    const Eigen::Vector2d place = seen.grid.origin + kCellM * cell;
    seen.middle = seen.grid.T_table_camera.inverse() * Eigen::Vector3d(place.x(), place.y(), 0);
  }
  evidence.inliers = seen.grid.samples_on_plane * scaleOf(view);
  evidence.carried = static_cast<int>(kNormalView);
  return seen;
}

bool liesUnder(const Plane& plane, const Plane& other, const Eigen::Vector3d& place_on_other) {
  return plane.normal.dot(other.normal) > kUnderCosine && plane.normal.dot(place_on_other) + plane.d > kMinUnderM;
}

TableEvidence judgeTable(const SurfaceSamples& view, const Plane& plane, const SeenPlane& seen, double focal) {
  TableEvidence evidence = seen.evidence;
  const PlaneGrid& grid = seen.grid;
  if (grid.empty()) return evidence;
  const cv::Mat_<uchar>& core = seen.core;
  cv::Mat_<uchar> inner;  // less a rim, where neighbours of the table show
  cv::erode(core, inner, cv::Mat::ones(3, 3, CV_8U));

  // Samples over and under the extent.
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = grid.T_table_camera.linear().topRows<2>().cast<float>();
  cv::Mat_<uchar> above(view.height, view.width, uchar(0));
  cv::Mat_<uchar> over_core(view.height, view.width, uchar(0));
  std::vector<Eigen::Vector3f> points(view.samples.size()), table_points(view.samples.size());
  std::vector<float> depths;
  int below = 0;
  cv::Point cell;
  for (std::size_t i = 0; i < view.samples.size(); ++i) {
    const auto& sample = view.samples[i];
    if (!sample.valid()) continue;
    const float height = fast.height(sample.point);
    const Eigen::Vector2f foot = axes * sample.point;
    points[i] = sample.point;
    table_points[i] << foot, height;
    const bool inside = grid.cell(foot.x(), foot.y(), cell) && core(cell);
    if (height > sample.tolerance()) {
      above.data[i] = 255;
      over_core.data[i] = inside;
    } else if (!inside) {
      continue;
    } else if (height < -sample.tolerance()) {
      below += inner(cell) != 0 && height > -kUnderM;
    } else {
      depths.push_back(sample.point.z());
    }
  }
  evidence.below = double(below) / std::max(1, grid.samples_on_plane);
  if (!depths.empty()) evidence.distance_m = upperMedian(depths);

  // What stands on the plane goes on little beyond it; the walls of a bin do.
  int parts = 0;
  const Gap gap{kGapM, static_cast<float>(kGapPixels * view.stride / focal), kGapSigmas, DepthNoise()};
  const cv::Mat_<int> labels = connectPoints(points, above, gap, parts);
  std::vector<Group> groups(parts + 1);
  for (std::size_t i = 0; i < view.samples.size(); ++i) {
    if (above.data[i] == 0) continue;
    Group& group = groups[labels.ptr<int>()[i]];
    const int row = static_cast<int>(i) / view.width, column = static_cast<int>(i) % view.width;
    group.at_border += std::min({row, column, view.height - 1 - row, view.width - 1 - column}) < kBorderSamples;
    if (over_core.data[i] == 0) {
      ++group.outside;
      continue;
    }
    const Eigen::Vector3f& p = table_points[i];
    ++group.count;
    group.foot += p.z() < kFootHeightM;
    group.too_high += p.z() > kCeilingM;
    group.low = group.low.cwiseMin(p.head<2>());
    group.high = group.high.cwiseMax(p.head<2>());
  }
  const double wide = 0.5 * std::sqrt(evidence.area_m2);
  double carried = 0;
  for (const Group& group : groups) {
    if (group.count < kMinGroup || group.foot < kMinFootSamples) continue;
    const bool leaves = group.at_border > kLeaves * std::sqrt(static_cast<double>(group.count + group.outside));
    const bool unlikely = group.outside > kMaxOutside * group.count || 2 * group.too_high > group.count ||
                          (group.high - group.low).maxCoeff() > wide;
    // A table stands on the floor: what is over the ceiling is not carried, whatever it belongs to.
    carried += (group.count - group.too_high) * (unlikely ? kUnlikely : leaves ? kLeaving : 1.0);
  }
  evidence.carried = static_cast<int>(carried * scaleOf(view));
  return evidence;
}

double TableEvidence::score(const Plane& plane, bool hidden_counts) const {
  const double orientation = 0.9 - 0.1 * plane.normal.y();  // upwards in the image is likely, nothing is excluded
  const double near = std::max(kMinDistanceWeight, std::min(1.0, (kFarM - distance_m) / (kFarM - kNearM)));
  const double known_m2 = hidden_counts ? seen_m2 + hidden_m2 : seen_m2;
  const double area = std::pow(std::min(1.0, known_m2 / kFullAreaM2), 2);  // leaves out the tops and fronts of boxes
  const double carries = 0.3 + std::log2(1 + carried / 20.0);
  return orientation * near * area * carries / (1 + kBelowWeight * below) *
         std::sqrt(std::min(1.0, inliers / kEnoughInliers));
}

}  // namespace objectness

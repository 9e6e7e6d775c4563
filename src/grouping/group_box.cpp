// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/group_box.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "grouping/extremes.hpp"

namespace objectness {
namespace {

constexpr double kTiltGain = 0.8;  // a tilted box must be this much smaller than the upright one
constexpr double kMinTilt_deg = 6;
constexpr double kTrimmed = 0.01;

/// Two unit vectors that make a right-handed frame with z.
Eigen::Matrix3f frameAround(const Eigen::Vector3f& z) {
  const Eigen::Vector3f x = z.unitOrthogonal();
  Eigen::Matrix3f axes;
  axes << x, z.cross(x), z;
  return axes;
}

/// The box with the given z axis whose footprint across it is the rectangle of least area.
OrientedBox boxAlong(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& z, double min_size_m) {
  Eigen::Matrix3f axes = frameAround(z);
  std::vector<cv::Point2f> footprint;
  footprint.reserve(points.size());
  for (const auto& p : points) footprint.emplace_back(axes.col(0).dot(p), axes.col(1).dot(p));
  const double yaw = cv::minAreaRect(outerPoints(footprint)).angle * CV_PI / 180;
  axes = axes * Eigen::AngleAxisf(static_cast<float>(yaw), Eigen::Vector3f::UnitZ()).toRotationMatrix();

  Eigen::Vector3f centre;
  OrientedBox box;
  std::vector<float> along(points.size());
  const std::size_t k = static_cast<std::size_t>(kTrimmed * (points.size() - 1));
  std::vector<float> few;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i) along[i] = axes.col(axis).dot(points[i]);
    const float low = smallestButFew(k, along, few);
    const float high = largestButFew(k, along, few);
    centre[axis] = 0.5f * (low + high);
    box.size_m[axis] = std::max<double>(min_size_m, high - low);
  }
  box.T_camera_box.linear() = axes.cast<double>();
  box.T_camera_box.translation() = (axes * centre).cast<double>();
  return box;
}

/// The same box with its axes renamed: z is the one nearest to the table's normal, and points upwards.
OrientedBox standing(const OrientedBox& box) {
  const Eigen::Matrix3d& axes = box.T_camera_box.linear();
  int z = 2;
  for (const int axis : {0, 1}) {
    if (std::abs(axes(2, axis)) > std::abs(axes(2, z)) + 1e-6) z = axis;
  }
  const double sign = axes(2, z) < 0 ? -1 : 1;
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  OrientedBox turned = box;
  turned.T_camera_box.linear() << sign * axes.col(x), axes.col(y), sign * axes.col(z);
  turned.size_m = {box.size_m[x], box.size_m[y], box.size_m[z]};
  return turned;
}

}  // namespace

OrientedBox tightBox(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& directions,
                     double min_size_m) {
  OrientedBox best = boxAlong(points, Eigen::Vector3f::UnitZ(), min_size_m);
  double best_volume = kTiltGain * best.size_m.prod();
  const double min_tilt = std::sin(kMinTilt_deg * M_PI / 180);
  for (const Eigen::Vector3f& direction : directions) {
    // As one of three axes at right angles it may stand for any of them: the box is the same.
    const double upright = std::abs(direction.z()), across = direction.head<2>().norm();
    if (std::min(upright, across) < min_tilt) continue;
    const OrientedBox box = boxAlong(points, direction, min_size_m);
    if (box.size_m.prod() >= best_volume) continue;
    best = box;
    best_volume = box.size_m.prod();
  }
  return standing(best);
}

}  // namespace objectness

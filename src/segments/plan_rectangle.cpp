// SPDX-License-Identifier: BSD-3-Clause
#include "segments/plan_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <opencv2/imgproc.hpp>

#include "common/angles.hpp"
#include "common/share_below.hpp"

namespace objectness {
namespace {

using Eigen::Vector2d;

constexpr float kUpright = 0.3f, kWall = 0.35f;
constexpr double kShare = 0.7;
constexpr double kMinAgreement = 0.6, kMinWeight = 0.1, kMaxGrowth = 1.15;
constexpr double kTrimmed = 0.005, kFewer = 0.003;
constexpr double kFoot = 0.3, kMinHeightM = 0.015;  // what is lower than this has no foot to leave out
constexpr std::size_t kMinPoints = 20;
constexpr double kBinM = 0.003;
constexpr int kMinBins = 8, kMaxBins = 60;
constexpr double kSparse = 0.5;  // of the median number of points in a bin

std::vector<Vector2d> planOf(const SeenThing& thing) {
  const double foot_m = thing.height() > kMinHeightM ? thing.base_m + kFoot * thing.height() : -1;
  std::vector<Vector2d> plan;
  for (const SeenPoint& q : thing.points) {
    if (q.place.z() >= foot_m) plan.push_back(q.place.head<2>().cast<double>());
  }
  if (plan.size() >= kMinPoints) return plan;
  plan.clear();
  for (const SeenPoint& q : thing.points) plan.push_back(q.place.head<2>().cast<double>());
  return plan;
}

std::vector<float> along(const std::vector<Vector2d>& plan, double angle_rad) {
  const Vector2d axis(std::cos(angle_rad), std::sin(angle_rad));
  std::vector<float> values;
  values.reserve(plan.size());
  for (const Vector2d& p : plan) values.push_back(static_cast<float>(axis.dot(p)));
  return values;
}

PlanRectangle rectangleAt(const std::vector<Vector2d>& plan, double yaw_rad, double trimmed) {
  PlanRectangle rectangle;
  rectangle.yaw_rad = yaw_rad;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<float> values = along(plan, yaw_rad + axis * kPi / 2);
    rectangle.low[axis] = shareBelow(trimmed, values);
    rectangle.high[axis] = shareBelow(1 - trimmed, values);
  }
  return rectangle;
}

double yawOfLeastArea(const std::vector<Vector2d>& plan) {
  std::vector<cv::Point2f> points;
  for (const Vector2d& p : plan) points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  return cv::minAreaRect(points).angle * kDegree;
}

/// Takes the ends off where a face of even density has run out and only a fringe goes on.
void endWithFaces(const std::vector<Vector2d>& plan, PlanRectangle& rectangle) {
  const PlanRectangle all = rectangleAt(plan, rectangle.yaw_rad, kFewer);
  for (int axis = 0; axis < 2; ++axis) {
    const double size_m = all.high[axis] - all.low[axis];
    if (!(size_m > 0)) continue;
    const int bins = std::clamp(static_cast<int>(size_m / kBinM), kMinBins, kMaxBins);
    std::vector<int> count(bins, 0);
    for (const float value : along(plan, rectangle.yaw_rad + axis * kPi / 2)) {
      const double bin = (value - all.low[axis]) / size_m * bins;
      if (bin >= 0 && bin < bins) ++count[static_cast<int>(bin)];
    }
    std::vector<float> smooth;
    for (int i = 0; i < bins; ++i) {
      const int first = std::max(0, i - 1), last = std::min(bins - 1, i + 1);
      float sum = 0;
      for (int j = first; j <= last; ++j) sum += static_cast<float>(count[j]);
      smooth.push_back(sum / static_cast<float>(last - first + 1));
    }
    const double sparse = kSparse * shareBelow(0.5, smooth);
    int low = 0, high = bins - 1;
    while (low < bins / 3 && count[low] < sparse) ++low;
    while (high > 2 * bins / 3 && count[high] < sparse) --high;
    rectangle.low[axis] = std::max(rectangle.low[axis], all.low[axis] + size_m * low / bins);
    rectangle.high[axis] = std::min(rectangle.high[axis], all.low[axis] + size_m * (high + 1) / bins);
  }
}

}  // namespace

Vector2d PlanRectangle::toPlan(const Vector2d& own) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {c * own.x() - s * own.y(), s * own.x() + c * own.y()};
}

Vector2d PlanRectangle::toOwn(const Vector2d& plan) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {c * plan.x() + s * plan.y(), -s * plan.x() + c * plan.y()};
}

FaceDirection faceDirection(const SeenThing& thing) {
  FaceDirection faces;
  std::complex<double> sum = 0;
  double total = 0;
  for (const SeenPoint& q : thing.points) {
    if (!q.has_normal || q.upright < kUpright) continue;
    sum += std::polar<double>(q.upright, 4 * std::atan2(q.normal.y(), q.normal.x()));
    total += q.upright;
  }
  if (total == 0) return faces;
  faces.yaw_rad = std::arg(sum) / 4;
  faces.agreement = std::abs(sum) / total;
  faces.weight = total / static_cast<double>(thing.points.size());
  std::vector<float> turns;
  for (const SeenPoint& q : thing.points) {
    if (!q.has_normal || q.upright < kWall) continue;
    const double yaw = std::atan2(q.normal.y(), q.normal.x());
    turns.push_back(static_cast<float>(std::abs(std::remainder(yaw - faces.yaw_rad, kPi / 2)) / kDegree));
  }
  if (!turns.empty()) faces.turn_deg = shareBelow(kShare, turns);
  return faces;
}

PlanRectangle seenRectangle(const SeenThing& thing, const FaceDirection& faces) {
  const std::vector<Vector2d> plan = planOf(thing);
  const PlanRectangle least = rectangleAt(plan, yawOfLeastArea(plan), kTrimmed);
  if (faces.agreement <= kMinAgreement || faces.weight <= kMinWeight) return least;
  PlanRectangle by_faces = rectangleAt(plan, faces.yaw_rad, kTrimmed);
  if (by_faces.area() >= kMaxGrowth * least.area()) return least;
  endWithFaces(plan, by_faces);
  return by_faces;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/extremes.hpp"

#include <algorithm>
#include <functional>

namespace objectness {
namespace {

constexpr std::size_t kStride = 16;    // of the sample
constexpr float kRounding_m2 = 1e-7f;  // a point this near to a side of the octagon may be one of the hull
constexpr int kSides = 8;

/// The value at place k in the given order. Most values are only compared with a bound that a sample of them tells.
template <class Order>
float valueAt(std::size_t k, const std::vector<float>& values, std::vector<float>& few, Order order) {
  few.clear();
  for (std::size_t i = 0; i < values.size(); i += kStride) few.push_back(values[i]);
  const std::size_t place = std::min(few.size() - 1, 2 * k / kStride + 3);
  std::nth_element(few.begin(), few.begin() + place, few.end(), order);
  const float bound = few[place];
  few.clear();
  for (const float value : values) {
    if (!order(bound, value)) few.push_back(value);
  }
  if (few.size() <= k) few = values;  // an odd sample
  std::nth_element(few.begin(), few.begin() + k, few.end(), order);
  return few[k];
}

/// How far a point lies in one of four directions.
float along(int direction, const cv::Point2f& p) {
  return direction == 0 ? p.x : direction == 1 ? p.x + p.y : direction == 2 ? p.y : p.y - p.x;
}

}  // namespace

float smallestButFew(std::size_t k, const std::vector<float>& values, std::vector<float>& scratch) {
  return valueAt(k, values, scratch, std::less<float>());
}

float largestButFew(std::size_t k, const std::vector<float>& values, std::vector<float>& scratch) {
  return valueAt(k, values, scratch, std::greater<float>());
}

std::vector<cv::Point2f> outerPoints(const std::vector<cv::Point2f>& points) {
  if (points.empty()) return {};
  cv::Point2f corners[kSides];  // counter-clockwise
  for (int direction = 0; direction < kSides / 2; ++direction) {
    const auto ends = std::minmax_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return along(direction, a) < along(direction, b);
    });
    corners[direction] = *ends.second;
    corners[direction + kSides / 2] = *ends.first;
  }
  std::vector<cv::Point2f> outer;
  for (const cv::Point2f& p : points) {
    bool inside = true;
    for (int i = 0; i < kSides; ++i) {
      const cv::Point2f side = corners[(i + 1) % kSides] - corners[i];
      inside &= side == cv::Point2f() || side.cross(p - corners[i]) > kRounding_m2;
    }
    if (!inside) outer.push_back(p);
  }
  return outer.empty() ? points : outer;  // all of them in one place
}

}  // namespace objectness

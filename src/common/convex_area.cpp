// SPDX-License-Identifier: BSD-3-Clause
#include "common/convex_area.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace objectness {
namespace {

constexpr float kRounding = 1e-6f;

}  // namespace

ConvexArea::ConvexArea(std::vector<cv::Point2f> corners) : corners_(std::move(corners)) {
  const bool clockwise = cv::contourArea(corners_, true) < 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const cv::Point2f along = corners_[(i + 1) % corners_.size()] - corners_[i];
    const float length = static_cast<float>(cv::norm(along));
    if (!(length > 0)) continue;
    const cv::Point2f inwards = (clockwise ? 1 : -1) * cv::Point2f(along.y, -along.x) / length;
    sides_.push_back({inwards, inwards.dot(corners_[i])});
  }
}

bool ConvexArea::contains(const cv::Point2f& place, float margin) const {
  float inside = std::numeric_limits<float>::max();  // of the nearest side
  for (const Side& side : sides_) {
    const float distance = side.inwards.dot(place) - side.offset;
    if (!(distance >= -margin - kRounding)) return false;  // nor where a place is not a number
    inside = std::min(inside, distance);
  }
  if (inside > kRounding && sides_.size() > 2) return true;
  // Beyond a corner it may be farther from the polygon than from its sides.
  return cv::pointPolygonTest(corners_, place, true) >= -margin;
}

}  // namespace objectness

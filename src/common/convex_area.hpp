// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace objectness {

/// A convex polygon that is asked for many places; of either orientation.
class ConvexArea {
 public:
  ConvexArea() = default;
  explicit ConvexArea(std::vector<cv::Point2f> corners);

  /// Whether a place is inside or at most `margin` outside; a negative margin: at least so far inside.
  bool contains(const cv::Point2f& place, float margin) const;

 private:
  struct Side {
    cv::Point2f inwards;
    float offset;
  };
  std::vector<cv::Point2f> corners_;
  std::vector<Side> sides_;
};

}  // namespace objectness

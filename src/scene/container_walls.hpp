// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace objectness {

/// What lies within a convex outline and at least `margin_m` from it, about; metres.
class FloorArea {
 public:
  FloorArea(const std::vector<cv::Point2f>& outline, double margin_m);
  bool contains(const cv::Point2f& place) const;

 private:
  cv::Mat_<uchar> cells_;
  cv::Point2f origin_;
};

/// Height over a floor, metres, of the walls that enclose it on nearly all sides that are seen, and are about equally
/// high; nothing when there are none.
/// outline: of the floor, convex, metres; places, over_floor_m: of points in and around it; noise_m: what heights less
/// than this mean.
std::optional<double> wallHeight(const std::vector<cv::Point2f>& outline, const std::vector<cv::Point2f>& places,
                                 const std::vector<float>& over_floor_m, float noise_m);

/// No wall of a container whose walls have that height is higher, metres.
double highestWall(double wall_height_m);

}  // namespace objectness

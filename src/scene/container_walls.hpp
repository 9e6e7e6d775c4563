// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace objectness {

/// Height over a floor, metres, of the walls that enclose it on nearly all sides that are seen, and are about equally
/// high; nothing when there are none.
/// outline: of the floor, convex, metres; places, over_floor_m: of points in and around it; noise_m: what heights less
/// than this mean.
std::optional<double> wallHeight(const std::vector<cv::Point2f>& outline, const std::vector<cv::Point2f>& places,
                                 const std::vector<float>& over_floor_m, float noise_m);

/// No wall of a container whose walls have that height is higher, metres.
double highestWall(double wall_height_m);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/tracking/depth_fusion.hpp"

namespace objectness {

// Of inverse depth, 1 / metres: steps of the sensor are not below this.
constexpr float kLeastNoise = 0.0015f;
constexpr float kJumpSigmas = 4;  // what is farther off is no noise

/// The inverse depth of a point in the optical frame; 0: none.
inline float inverseOf(const Eigen::Vector3f& point) { return point.z() > 0 ? 1 / point.z() : 0; }  // NaN: 0

/// The largest noise of inverse depth that is taken for noise: a disparity error of 0.2 px at a baseline of 5 cm.
float mostNoise(const PinholeCamera& camera);

/// Standard deviation of one frame from the mean of `count` others, 1 to kMostFused, in those of one frame.
float sigmasOfMean(int count);

/// How far a frame is from what was known before it, by one in 16 of its pixels.
struct DepthDifference {
  float sigma = 0;              ///< of the deviations of inverse depth, reduced to those of one frame
  bool moved_together = false;  ///< they have one sign over whole parts of the picture: the camera moved
};

/// known: inverse depth by pixel, 0 where there is none, and of how many frames it is the mean.
DepthDifference compareDepth(const Frame& frame, const cv::Mat_<float>& known, const cv::Mat_<uchar>& count);

}  // namespace objectness

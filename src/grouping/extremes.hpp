// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace objectness {

/// The k-th smallest value, 0-based; fast for a k that is small beside the number of values.
/// values: not empty; k: less than their number; scratch: anything.
float smallestButFew(std::size_t k, const std::vector<float>& values, std::vector<float>& scratch);

/// The k-th largest value, 0-based.
float largestButFew(std::size_t k, const std::vector<float>& values, std::vector<float>& scratch);

/// The points without most of those inside of their hull: what lies within the octagon of the points that are farthest
/// in eight directions is left out. The hull stays what it was. No point may be NaN.
std::vector<cv::Point2f> outerPoints(const std::vector<cv::Point2f>& points);

}  // namespace objectness

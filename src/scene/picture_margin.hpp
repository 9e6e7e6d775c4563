// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace objectness {

/// Cameras often have no depth in the outermost pixels: what comes this near to the picture's border may leave it.
constexpr int kPictureMarginPx = 3;

/// Pixels between (u, v) and the nearest side of the picture; below 0 outside.
template <class Number>
Number pixelsToBorder(Number u, Number v, const cv::Size& picture) {
  return std::min({u, v, picture.width - 1 - u, picture.height - 1 - v});
}

}  // namespace objectness

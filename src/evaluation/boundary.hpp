// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <utility>
#include <vector>

namespace objectness::evaluation {

/// The outermost pixels of a mask's connected parts: 1 on them, 0 elsewhere; holes have none.
cv::Mat_<uchar> outline(const cv::Mat_<uchar>& mask);

struct BoundaryFit {
  double precision = 0, recall = 0;
};

/// Of all outline pixels of the segments (precision) and of the objects (recall) the share that lies within
/// ceil(0.003 * image diagonal) pixels of the outline of its partner. pairs: (object, segment).
BoundaryFit compareBoundaries(const std::vector<cv::Mat_<uchar>>& objects, const std::vector<cv::Mat_<uchar>>& segments,
                              const std::vector<std::pair<int, int>>& pairs);

}  // namespace objectness::evaluation

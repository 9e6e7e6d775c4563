// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "baselines/baselines_config.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Which cluster of the mask's points each pixel is of, 1 and above, 0 = none: width * height labels.
std::vector<int> labelEuclideanClusters(const Frame& frame, const cv::Mat_<uchar>& mask, const EuclideanConfig& config);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "baselines/baselines_config.hpp"
#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// Which segment of the points above the table each pixel is of, 1 and above, 0 = none: width * height labels.
std::vector<int> labelLccp(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& object_mask,
                           const LccpConfig& config);
std::vector<int> labelCpc(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& object_mask,
                          const CpcConfig& config);

}  // namespace objectness

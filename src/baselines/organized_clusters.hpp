// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Which connected component of the mask's points each pixel is of, 1 and above, 0 = none: width * height labels.
/// Neighbouring pixels nearer than distance_m are connected; depth_dependent: that is at 1 m, and grows with the depth
/// squared (pcl::OrganizedConnectedComponentSegmentation by a pcl::EuclideanClusterComparator).
std::vector<int> labelOrganizedClusters(const Frame& frame, const cv::Mat_<uchar>& mask, double distance_m,
                                        bool depth_dependent);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

/// How far neighbouring pixels may be from each other in space and still show one thing: the largest of three lengths.
struct Gap {
  float constant_m;
  float per_depth;  ///< metres per metre of depth: a surface seen at a grazing angle
  float sigmas;
  DepthNoise noise;

  float at(float z) const;
};

/// Labels the connected parts (8 neighbours, gap in space) of a mask; `points` has the mask's size, row-major, and is
/// valid wherever the mask is set. 0 = not in the mask, 1..count = part, in the order of their first pixels.
cv::Mat_<int> connectPoints(const std::vector<Eigen::Vector3f>& points, const cv::Mat_<uchar>& mask, const Gap& gap,
                            int& count, int threads = 1);

}  // namespace objectness

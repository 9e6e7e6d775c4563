// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "objectness_segmentation/segments/unmeasured.hpp"

namespace objectness {

/// A hole of the picture without what is thinner than the noise around it.
struct CompactHole {
  cv::Rect area;              ///< of the picture, a pixel wider than the hole on every side
  cv::Mat_<uchar> mask;       ///< of the area's size, 255 = hole, one connected part (4 neighbours)
  int pixels = 0;             ///< of the mask
  float radius_px = 0;        ///< of the largest circle in it: to the nearest pixel outside
  float noise_radius_px = 0;  ///< the frame's own holes in the table have smaller ones, nine of ten
};

/// Holes within the picture, at least a quarter of their sides on the table, into which the wanted circles fit
/// (UnmeasuredConfig), less what sticks out of them. no_depth, on_table: H x W, non-zero = so. In the order of the
/// first pixels of connected holes.
std::vector<CompactHole> compactHoles(const PinholeCamera& camera, const Plane& table, const cv::Mat_<uchar>& no_depth,
                                      const cv::Mat_<uchar>& on_table, const UnmeasuredConfig& config);

}  // namespace objectness

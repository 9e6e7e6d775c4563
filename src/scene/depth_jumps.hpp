// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

/// Bits of Normals::jump.
constexpr unsigned char kJumpRight = 1;
constexpr unsigned char kJumpDown = 2;

/// Normals::jump of a frame. Neighbours are apart when one of them is missing or |dz| exceeds both what noise and what
/// a surface seen at grazing angle explain. Nothing is set towards the outside of the image.
std::vector<unsigned char> findDepthJumps(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise);

/// H x W, per pixel the radius of the largest square window around it without a missing pixel, a jump or the outside,
/// at most 255; 0 beside those. (At the very end of a jump's line the window may touch it with its border.)
cv::Mat_<uchar> clearRadius(const Frame& frame, const std::vector<unsigned char>& jump);

}  // namespace objectness

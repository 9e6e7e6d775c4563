// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

/// Normals::jump of a frame: bit 0 to the right, bit 1 downwards. Neighbours are apart when one of them is missing or
/// |dz| exceeds both what noise and what a surface seen at grazing angle explain. Nothing is set towards the outside of
/// the image.
std::vector<unsigned char> findDepthDiscontinuities(const Frame& frame, const NormalsConfig& config,
                                                    const DepthNoise& noise, int threads = 1);

/// H x W, per pixel the radius of the largest square window around it without a missing pixel, a jump or the outside,
/// at most `most` (up to 255); 0 beside those. (At the very end of a jump's line the window may touch it with its
/// border.)
cv::Mat_<uchar> clearRadius(const Frame& frame, const std::vector<unsigned char>& jump, int threads = 1,
                            int most = 255);

}  // namespace objectness

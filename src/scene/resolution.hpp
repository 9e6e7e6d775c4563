// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/resolution_config.hpp"

namespace objectness {

/// How many pixels each way are worth one: 1 where the picture is as coarse as it should be. A depth camera's noise is
/// one over many pixels: a surface is sampled finer than it is known, and what is fitted in windows of pixels sees
/// the noise instead of the surface.
int averagedPixels(const Frame& frame, const ResolutionConfig& config);

/// A frame of blocks of `factor` x `factor` pixels, the last ones of a row or column cut off by the picture's end. Of a
/// block that a depth jump crosses the nearer surface is averaged, if it has half of the pixels that have depth, else
/// the farther one; a block of which less than half has depth has none. A block of bridged pixels alone is bridged.
Frame averageBlocks(const Frame& frame, int factor, int threads = 1);

/// By pixel of `frame`, the pixel of `coarse` = averageBlocks(frame, factor) that saw its surface: that of its block,
/// or of the blocks around the one next in depth, when that is much nearer; -1 without depth.
std::vector<int> blocksOf(const Frame& frame, const Frame& coarse, int factor, int threads = 1);

/// Labels, such as a scene's truth, for the pixels of averageBlocks(): of each block those of the pixel in its middle.
cv::Mat_<ushort> labelsOfBlocks(const cv::Mat_<ushort>& labels, int factor);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/cues/superpixels.hpp"

namespace objectness {

/// Smooth pixels, and which of their neighbours are on the same surface: near in depth and alike in normal.
struct SmoothSurface {
  /// To neighbours to the right and in the row below; the others have a bit to this pixel.
  enum Way : uchar { kRight = 1, kLowerLeft = 2, kDown = 4, kLowerRight = 8 };

  cv::Mat_<uchar> smooth;  ///< H x W, 255 = yes
  cv::Mat_<uchar> ways;    ///< H x W, bits of Way; 0 where not smooth
};

SmoothSurface connectSmooth(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                            const cv::Mat_<uchar>& smooth, const SuperpixelsConfig& config, int threads = 1);

}  // namespace objectness

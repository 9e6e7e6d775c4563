// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/cues/superpixels.hpp"

namespace objectness {

/// Grows pieces of surface over the pixels where `smooth` is set, from their middles outwards (a watershed of the
/// distance to the nearest cut). Where two pieces meet, they become one unless the place is narrow beside both of
/// them: a cut that noise has left open somewhere still holds. Neighbours also need like depths and normals.
/// Returns for every pixel the index of the first pixel of its piece; -1 where no piece is or it is too small.
cv::Mat_<int> growPieces(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                         const cv::Mat_<uchar>& smooth, const SuperpixelsConfig& config, int threads = 1);

}  // namespace objectness

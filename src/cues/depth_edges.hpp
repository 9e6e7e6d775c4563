// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/cues/edges.hpp"

namespace objectness {

/// Depth edges of the whole image, EdgeKind bits: neighbours, or the two sides of a patch of missing depth, that lie
/// further apart in depth than noise and a grazing surface explain; border where nothing lies across the patch. first:
/// what lies left of this pixel or above it is not needed, and undefined.
cv::Mat_<uchar> findDepthEdges(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                               const EdgesConfig& config, int threads = 1, cv::Point first = {0, 0});

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/plane_grid.hpp"

namespace objectness {

/// Noise of the depth readings on a plane, from the samples behind it within the extent (a grid of extentOf()): nothing
/// that stands on the table gets there. The prior when too few samples are left.
DepthNoise measureNoise(const SurfaceSamples& samples, const Plane& plane, const PlaneGrid& grid,
                        const cv::Mat_<uchar>& extent, int threads = 1);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Where surface distances may lead.
struct GeodesicLimits {
  double max_step_m = 0.015;  ///< neighbouring pixels farther apart than this are not connected
  double max_reach_m = 0.04;  ///< how far from a source a pixel is still reached
};

/// Gives each pixel that is `open` and has no owner yet (owner < 0) the owner it is nearest to along the surface:
/// shortest paths over 8 neighbours through open pixels, a step as long as the 3D distance. Ties go to the lower owner.
/// owner: H x W, changed in place; open: H x W, non-zero = may be walked on and assigned.
/// The same for any number of threads.
void assignGeodesic(const Frame& frame, const cv::Mat_<uchar>& open, const GeodesicLimits& limits, cv::Mat_<int>& owner,
                    int threads = 1);

}  // namespace objectness

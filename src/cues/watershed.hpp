// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cues/smooth_surface.hpp"

namespace objectness {

/// Grows pieces of surface, from their middles outwards (a watershed of the distance to the nearest pixel that is not
/// smooth). Regions merge only over a contact that is wide beside both of them, so a boundary with a leak still
/// separates.
/// Returns for every pixel the index of the first pixel of its piece; -1 where no piece is or it is too small.
cv::Mat_<int> growRegions(const Frame& frame, const SmoothSurface& surface, const SuperpixelsConfig& config);

}  // namespace objectness

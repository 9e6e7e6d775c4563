// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Least-squares pinhole intrinsics of an organized cloud: u = fx x/z + cx, v = fy y/z + cy over the valid points.
/// kBadCamera when there are too few points or the grid is no pinhole view (median residual over half a pixel); the
/// reason says whether it is one from another frame than the optical one.
Result<PinholeCamera> recoverCamera(const RawCloud& cloud);

}  // namespace objectness

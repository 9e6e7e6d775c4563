// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Puts a list of points back on the pixel grid of the camera that took it; the nearest of several points of a pixel
/// wins. kNotOrganized when the list is no view of the camera (checkIsView()).
Result<Frame> organize(const RawCloud& cloud, const PinholeCamera& camera);

}  // namespace objectness

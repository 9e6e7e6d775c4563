// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Whether an organized cloud is the view of a pinhole camera that stands anywhere in the frame of its points.
bool isMovedView(const RawCloud& cloud);

}  // namespace objectness

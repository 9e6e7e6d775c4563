// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/objectness/box.hpp"

namespace objectness::evaluation {

/// Volume that two boxes share, cubic metres; exact for boxes in any orientation.
double sharedVolume(const OrientedBox& a, const OrientedBox& b);

/// Intersection over union of two boxes' volumes, 0 to 1; 0 when either box is empty.
double boxOverlap(const OrientedBox& a, const OrientedBox& b);

}  // namespace objectness::evaluation

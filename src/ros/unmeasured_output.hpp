// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/Unmeasured.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "objectness_segmentation/segments/unmeasured.hpp"

namespace objectness_segmentation {

std::vector<Unmeasured> toUnmeasuredMessages(const std::vector<objectness::Unmeasured>& things);

/// Per thing its outline and, where it has one, its box: namespace "unmeasured", ids 2 k and 2 k + 1.
void addUnmeasured(const std::vector<objectness::Unmeasured>& things, const std_msgs::Header& header,
                   std::vector<visualization_msgs::Marker>& markers);

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <opencv2/core.hpp>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness::evaluation {

/// Where the box around visible points begins.
enum class BoxBase { kTable, kLowestPoint };

/// For each owner of pixels the upright box, up to its top, over the smallest rectangle about its visible points.
/// Single points off its surface are left out, and owners without surface or height. owners: H x W, -1 of what nobody
/// owns. Camera frame, metres.
std::map<int, OrientedBox> visibleBoxes(const Frame& frame, const Table& table, const cv::Mat_<int>& owners,
                                        BoxBase base);

}  // namespace objectness::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

/// The tight box of points in the table frame: turned about the table's normal at any height or, where that makes it
/// clearly smaller, with one of the given directions as an axis (things that lean). Its own z axis is the one nearest
/// to the table's normal. Faces lie at the 1 and 99 percentile of the points along their axis, at least min_size_m
/// apart. The box is in the frame of the points, T_camera_box then maps from it to the table frame.
OrientedBox tightBox(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& directions,
                     double min_size_m);

}  // namespace objectness

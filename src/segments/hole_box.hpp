// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// The upright box of a thing without depth that is as deep as it is wide, from where the rays past it meet the table
/// (table frame, metres). Seen from above, the camera's rays touch a circle of that width on both sides and in front;
/// the ray over its farthest point tells how high it is: Criminisi et al., Single View Metrology, 2000, with the camera
/// at a known height. Nothing where the outline is hardly longer than the circle, as of what lies flat.
std::optional<OrientedBox> boxOfHole(const Table& table, const std::vector<Eigen::Vector2d>& outline);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness::evaluation {

/// Where the points above the table lie: a rectangle in the table frame, metres.
struct Footprint {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};

/// A list of boxes that does not depend on what is in the scene, to compare proposals with: box i has the i-th size of
/// a list of household sizes, over and over, and the i-th position and angle of a sequence that fills the footprint and
/// [0, 180) degrees evenly from the start (Roberts' R3 sequence). All boxes stand on the table, within the footprint as
/// far as their size lets them. The first boxes of a longer list are those of a shorter one. Camera frame, metres.
std::vector<OrientedBox> fixedBoxes(const Table& table, const Footprint& footprint, int count);

}  // namespace objectness::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

/// The same box with its axes renamed, so that equal scenes give equal axes. box: in the table frame.
/// z: the axis nearest to the table's normal, away from the table. x: the longer of the other two; of sides that differ
/// by less than 3 % the one nearer to the camera's x axis laid on the table. x points to that side, too (and away from
/// the camera when it is at right angles to it). y completes a right-handed frame.
OrientedBox nameAxes(const OrientedBox& box);

/// The same box with its axes named, of the 24 ways, so that it is turned least against `axes`; of equal ones the
/// first.
OrientedBox namedAs(const Eigen::Matrix3d& axes, const OrientedBox& box);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/segments/segments.hpp"

namespace objectness {

/// Lets every box end where its thing stands. The lowest points of a thing are too near to the table to be taken for
/// it, and others may hide its foot: a box around what is seen hovers.
///
/// An upright box gets its lower face, a tilted one is lengthened downwards along its own z axis until its lowest
/// corner is there: on the table, or on the top of a thing whose place in the plan is under the box and that does not
/// reach higher than where the box's own points begin. The other faces stay. Things are the segments and what else of
/// `above` is connected. normals: of the frame. Reads nothing but its arguments, writes nothing but the boxes.
void restBoxes(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& above,
               std::vector<Segment>& segments);

}  // namespace objectness

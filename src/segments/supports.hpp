// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/object_points.hpp"
#include "segments/segments.hpp"

namespace objectness {

/// What every segment stands on: the highest top of the things whose place in the plan is under the segment's box and
/// that do not reach higher than where its own points begin, otherwise the table. TableClusters are the segments and
/// what else of `above` is connected. No segment rests on itself by way of others.
///
/// The lowest points of a thing are too near to the table to be taken for it, and others may hide its foot: its points
/// alone do not tell where it stands. segments: with boxes around what is seen of them. normals: of the frame.
std::vector<Support> findSupports(const Frame& frame, const Normals& normals, const Table& table,
                                  const ObjectPoints& above, const std::vector<Segment>& segments);

/// Lets a box end at its support, `support_m` over the table: an upright box gets its lower face there, a tilted one is
/// lengthened downwards along its own z axis until its lowest corner is there. The other faces stay. A tilted box is
/// not shortened, and no box gets lower than half a centimetre.
void restBox(const Table& table, double support_m, OrientedBox& box);

}  // namespace objectness

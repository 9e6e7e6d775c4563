// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/segments/segments_config.hpp"
#include "segments/segments.hpp"

namespace objectness {

/// Takes out of `segments` what stands around the objects, and returns it: both in their order.
///
/// Judged apart from grouping, so that it cannot merge things, and by nothing but where a segment is seen:
/// - what leaves the picture and reaches over the table's edge, or lies beside the table: arms, people, furniture;
/// - what leaves the picture and is no higher than a table's own bend there.
/// Reads nothing but its arguments.
std::vector<Segment> takeBackground(const Frame& frame, const Table& table, const ObjectPoints& above,
                                    std::vector<Segment>& segments);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/object_points.hpp"
#include "segments/segments.hpp"

namespace objectness {

/// Gives every segment the box of its whole object, from its support to its top, and tells what stands on what.
///
/// What is not seen follows from what is seen:
/// - Round things (can, bowl, bottle, ball): the axis that normals and radii agree on. The box is square and turned to
///   the camera; `round` is set. Of a round body with something at one side (a mug and its handle) the box is as wide
///   as the body, x points to that side and ends with it; `round` is not set.
/// - Books and boards that lean: their face, and how thick they are seen to be.
/// - Anything else: the upright box over the rectangle of what is seen, turned as its faces are. A side that goes on
///   behind something, or behind the object's own front where no top is seen, is continued to at most 1.2 of the other
///   side, and not into space that the camera sees to be free or that others take.
/// Axes: nameAxes() in src/segments/box_axes.hpp; z away from the table, x the longer side, right-handed.
///
/// segments: with boxes around what is seen, which become their visible_box. labels: labelImage() of them. normals: of
/// the frame. Their pixels and their order stay. Does not depend on the number of threads.
void completeBoxes(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& above,
                   const cv::Mat_<ushort>& labels, std::vector<Segment>& segments, int threads = 1);

}  // namespace objectness

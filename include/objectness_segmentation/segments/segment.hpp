// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/segments/support.hpp"

namespace objectness {

/// One object: its box and the pixels that are its own.
struct Segment {
  /// Of the whole object, from its support to its top (completeBoxes()); before that step, as visible_box.
  OrientedBox box;
  /// What the segmentation itself says. Default method: the tight box of what is seen; paper's: the selected box.
  OrientedBox visible_box;
  bool round = false;        ///< a thing of revolution about the box's z axis, its yaw is that of the view
  Support support;           ///< what it stands on
  std::vector<int> carried;  ///< indices of the segments that stand on it, ascending
  double objectness = 0;     ///< paper's method: delta of Eq. 6; default: expected overlap with an object, 0..1
  /// Paper's method: as CueValues says. Default: edge_density, outer_edges and straddling of GroupCues, free_space is
  /// GroupCues::free (a share of the box's volume), free_voxels 0.
  CueValues cues;
  std::vector<int> pixels;  ///< indices v * width + u, ascending, of measured points; in no other segment
};

/// What segments[0] is called in label images, clouds, messages and pictures; 1 is the table, 0 nothing.
constexpr int kFirstObjectLabel = 2;
constexpr int kTableLabel = 1;

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/group_parts.hpp"

namespace objectness {

// box: in the table frame, as the points of GroupParts are.

/// Points and edges by the faces of the group's box: the paper's cues, and how well the box fits.
void addBoxCues(const GroupParts& parts, const Members& group, const OrientedBox& box, GroupCues& cues);

/// What the camera sees of the volume of the box: shares that are occupied, hidden and free.
void addVolumeCues(const GroupParts& parts, const Members& group, const OrientedBox& box, GroupCues& cues);

}  // namespace objectness

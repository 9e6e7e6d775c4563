// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/group_parts.hpp"

namespace objectness {

/// What the links within a group and to the others say.
void addLinkCues(const GroupEvidence& evidence, const Members& group, GroupCues& cues);

/// What the outline of a group lies against.
void addOutlineCues(const GroupEvidence& evidence, const Members& group, GroupCues& cues);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "grouping/links.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/grouping/cues.hpp"
#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

/// A group with its tight box and its cues.
struct GroupHypothesis {
  std::vector<int> pieces;  ///< ascending
  OrientedBox box;          ///< camera's optical frame
  GroupCues cues;
  float objectness = 0;  ///< 0..1: expected overlap with a true object (judgeGroups()), or scoreGroupsByRule()
  float remembered = 0;  ///< 1: it is an object of the frame before; -1: it was none; 0: not known
};

/// What groups are judged by; must outlive the scorer.
struct GroupEvidence {
  const Frame& frame;
  const Table& table;
  const EdgeMap& edges;
  const Pieces& pieces;
  const Borders& borders;
  const std::vector<Link>& links;
};

/// Boxes and cues of the groups, in their order; does not depend on the number of threads.
std::vector<GroupHypothesis> describeGroups(const GroupEvidence& evidence, const std::vector<std::vector<int>>& groups,
                                            int threads);

}  // namespace objectness

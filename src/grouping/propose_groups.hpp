// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "grouping/links.hpp"
#include "objectness_segmentation/grouping/grouping_config.hpp"

namespace objectness {

/// How many groups are proposed at most. Every piece by itself is always one of them.
struct GroupLimits {
  std::size_t of_a_part;  ///< of pieces that links connect: a wall's groups must not cost the objects theirs
  std::size_t of_all;     ///< parts with many groups give theirs up first
};

/// Sets of pieces that may be one object, bottom-up over the links: every piece, the steps of three dendrograms, and
/// (grown) what a beam grows from each piece, and each of all these with one piece more or less. Of more
/// than the limits allow, the best linked ones. Sorted, no two the same.
std::vector<std::vector<int>> proposeGroups(int pieces, const std::vector<Link>& links, const GroupLimits& limits,
                                            const GroupKinds& kinds = {});

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/grouping/links.hpp"

namespace objectness {

/// Which groups are proposed beside the single pieces.
struct GroupKinds {
  bool dendrograms = true, grown = true;
};

/// Sets of pieces that may be one object, bottom-up over the links: every piece, the steps of three dendrograms, and
/// (grown) what a beam grows from each piece, and each of all these with one piece more or less. Sorted, no two the
/// same.
std::vector<std::vector<int>> proposeGroups(int pieces, const std::vector<Link>& links, std::size_t most,
                                            const GroupKinds& kinds = {});

}  // namespace objectness

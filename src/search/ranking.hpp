// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

/// Puts boxes in the order of better().
void sortBestFirst(std::vector<ScoredBox>& boxes);

/// The boxes of lists that are each in the order of better() in one list in that order, on up to `threads` threads (0:
/// one per processor).
std::vector<ScoredBox> mergeBestFirst(const std::vector<std::vector<ScoredBox>>& lists, int threads);

}  // namespace objectness

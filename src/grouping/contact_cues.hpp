// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/borders.hpp"
#include "objectness_segmentation/grouping/cues.hpp"

namespace objectness {

/// Cues of two pieces in contact: border.samples is not empty. Each side of a sample is seen as the mean of the smooth
/// points of its piece that lie nearest.
ContactCues findContactCues(const Frame& frame, const Normals& normals, const Table& table,
                            const Superpixels& superpixels, const Pieces& pieces, const Borders& borders, int first,
                            int second);

}  // namespace objectness

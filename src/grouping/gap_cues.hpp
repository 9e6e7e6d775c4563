// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "grouping/borders.hpp"
#include "objectness_segmentation/grouping/cues.hpp"

namespace objectness {

/// Points of each piece's outline, at most so many of each, evenly along its pixels.
std::vector<std::vector<int>> outlinePixels(const Pieces& pieces, int most, int threads = 1);

/// None when the pieces are farther apart than max_distance_m.
std::optional<GapCues> findGapCues(const Frame& frame, const Table& table, const ObjectPoints& object_points,
                                   const Pieces& pieces, const std::vector<std::vector<int>>& outlines, int first,
                                   int second, double max_distance_m);

}  // namespace objectness

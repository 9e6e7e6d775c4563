// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/height_map.hpp"

namespace objectness {

/// Clears the parts of the mask that belong to walls: the sides of a bin, the wall behind a table. They are patches of
/// one of the table's other planes, mostly beside the table, that go on beyond the picture or over the ceiling.
void removeWalls(const Frame& frame, const Normals& normals, const Table& table, const HeightMap& map,
                 const ObjectPointsConfig& config, cv::Mat_<uchar>& mask, int threads = 1);

}  // namespace objectness

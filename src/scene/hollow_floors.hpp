// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/table_clusters.hpp"

namespace objectness {

/// Adds the floors of hollow things to the mask: pixels at table height that one thing encloses, in the image and on
/// the table, and that lie a little higher than the table around the thing.
void addHollowFloors(const Frame& frame, const Table& table, const HeightMap& map, const TableClusters& clusters,
                     cv::Mat_<uchar>& mask);

}  // namespace objectness

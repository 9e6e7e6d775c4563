// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/height_map.hpp"

namespace objectness {

/// Euclidean clusters of a mask: its parts that are connected in space.
struct TableClusters {
  cv::Mat_<int> label;  ///< H x W, 0 = none, 1..count
  int count = 0;
};

/// Connects neighbouring mask pixels (8) whose points are close, over the border of the table's extent as well, and
/// keeps the clusters that stand on the table: enough of it, mostly over the extent, not reaching over the ceiling.
TableClusters findTableClusters(const Frame& frame, const Table& table, const HeightMap& map,
                                const ObjectPointsConfig& config, const cv::Mat_<uchar>& mask, int threads = 1);

}  // namespace objectness

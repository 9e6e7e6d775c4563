// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// Where every pixel is over or under the table. All H x W.
struct HeightMap {
  cv::Mat_<float> height_m;     ///< NaN = invalid point
  cv::Mat_<float> threshold_m;  ///< height that noise does not explain at this pixel, along the table's normal
  cv::Mat_<uchar> inside;       ///< 255 = the foot of the point lies on the table's extent
  cv::Mat_<uchar> beyond;       ///< 255 = it lies where the table may go on (TableExtent::kBeyond); empty: none does
};

HeightMap makeHeightMap(const Frame& frame, const Table& table, const ObjectPointsConfig& config, int threads = 1);

/// 255 = over the table. Hysteresis: a pixel counts when it is over its threshold together with its neighbours, or over
/// half of it and a few pixels from such a one, so that things keep their thin rims and feet.
cv::Mat_<uchar> aboveTable(const HeightMap& map);

}  // namespace objectness

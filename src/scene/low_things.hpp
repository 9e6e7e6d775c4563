// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/height_map.hpp"

namespace objectness {

/// 255 = a point of something low: its height is within the noise of a pixel, but that of the patch around it is not
/// within the noise of a patch. H x W, without what is in `above`.
///
/// Heights are taken over the smooth surface that the table has for the sensor, which is not quite a plane. The noise
/// of a patch is what patches of the table have under that surface. Of a region, patches of twice the evidence are
/// wanted; narrow bands, such as the rounded foot of a tall thing, are none.
cv::Mat_<uchar> lowThings(const HeightMap& map, const ObjectPointsConfig& config, const cv::Mat_<uchar>& above,
                          int threads = 1);

}  // namespace objectness

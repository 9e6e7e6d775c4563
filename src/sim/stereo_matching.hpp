// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/depth_sensor.hpp"

namespace objectness::sim {

/// Depths as block matching sees them, metres, 0 = none: the disparity of a pixel is the mean over its matching window
/// of all that lies within a small step of it. Creases become round, and a thing's foot runs out into the table.
cv::Mat_<double> matchedDepths(const SurfaceView& view, const DepthSensor& sensor, int threads);

}  // namespace objectness::sim

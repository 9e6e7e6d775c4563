// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/depth_sensor.hpp"

namespace objectness::sim {

/// Depths as the phase of modulated light gives them (DepthSensor, [L], [K10], [J]), before noise; metres, 0 = none.
/// - A pixel adds up the light of all surfaces that it sees in part, which its lens spreads over its neighbours: where
///   these lie at different depths, the phase is that of a point between them (flying pixels). Pixels whose light
///   contradicts itself have no depth.
/// - A part of the light comes by way of another surface near it in the picture, on a longer path: concave corners look
///   rounder and farther away.
/// - The phase is off by a wave of the distance (wiggling).
cv::Mat_<double> timeOfFlightDepths(const SurfaceView& view, const DepthSensor& sensor, int threads);

}  // namespace objectness::sim

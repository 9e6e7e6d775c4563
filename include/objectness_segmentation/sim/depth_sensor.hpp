// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/sim/shapes.hpp"

namespace objectness::sim {

/// A structured-light depth camera like the first Kinect, its colour image registered to the depth.
struct DepthSensor {
  PinholeCamera camera{525, 525, 319.5, 239.5, 640, 480};
  double baseline_m = 0.075;  ///< projector to the right of the camera: what it does not light has no depth
  /// Depth comes in steps of z^2 / (f * baseline) times this (Khoshelham & Elberink 2012).
  double disparity_step_px = 0.125;
  double min_depth_m = 0.4, max_depth_m = 4.0;
  double max_incidence_deg = 82;  ///< surfaces seen at a flatter angle give no depth

  /// Standard deviation of the depth along the ray, metres (Nguyen, Izadi & Lovell 2012).
  double sigma(double z) const { return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4); }
};

/// What the sensor sees from T_world_camera (optical frame). Labels are those of the bodies, 0 where there is no depth.
/// The noise is smooth over three pixels, as a matching window makes it, and depends on the seed alone.
SceneImages takePicture(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                        const DepthSensor& sensor, std::uint32_t seed);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

/// A rectified pinhole camera in the ROS optical frame (REP 103: x right, y down, z forward; metres).
/// Pixel centres have integer coordinates: pixel (u, v) sees the ray ((u - cx) / fx, (v - cy) / fy, 1).
struct PinholeCamera {
  double fx = 0, fy = 0;  ///< focal lengths, pixels
  double cx = 0, cy = 0;  ///< principal point, pixels
  int width = 0, height = 0;

  Eigen::Vector2d project(const Eigen::Vector3d& p) const { return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy}; }
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0}; }

  /// Pixels that one metre at one metre's distance spans: the scale between metric and pixel windows.
  double focal() const { return 0.5 * (fx + fy); }
};

/// The camera that sees every so many-th row and column of another one's image, from the first.
PinholeCamera thinned(PinholeCamera camera, int step);

/// Finite, positive focal lengths and sizes, principal point within ten image sizes; otherwise kBadCamera with the
/// reason.
Status validate(const PinholeCamera& camera);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "objectness_segmentation/scene/camera.hpp"
#include "sim/levels.hpp"
#include "sim/placement.hpp"

namespace objectness::sim {

/// Where the camera stands and where on the table it looks.
struct Viewpoint {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();

  /// The direction from the camera to the point, seen from above: the angle from the world's x axis.
  double bearing(const Eigen::Vector2d& point) const;
};

/// A pose of that range that has a disc of that radius on the table about `target` in view.
Viewpoint drawViewpoint(const Eigen::Vector2d& target, double radius_m, const ViewRange& range,
                        const PinholeCamera& camera, Random& random);

/// Where the optical axis meets the table; nothing when it does not.
std::optional<Viewpoint> givenViewpoint(const Eigen::Isometry3d& T_world_camera);

/// Whether the thing is wholly within the picture and not too near for a depth camera.
bool isInView(const Placed& placed, const Viewpoint& viewpoint, const PinholeCamera& camera);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "sim/bodies.hpp"

namespace objectness::sim {

/// What is on the table, as the truth of it.
struct SceneObject {
  std::string kind;                                               ///< "box", "mug", ...
  int label = 0;                                                  ///< trueLabel()
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();  ///< centre of its tight box, axes of its own frame
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();               ///< of that box
};

/// What is neither table nor object and yet looked at: a tray, tote or shelf (kStageLabel) or what stands around the
/// table (kAroundLabel).
struct SceneBackground {
  std::string kind;  ///< "tray", "arm", ...
  int label = 0;
};

/// A table with what is on and around it. World frame: z up, what the things stand on is the plane z = 0: the table's
/// top, or the floor of a tray, tote or shelf that stands on the table. The table is about the origin, the floor lies
/// below, and a wall stands at +y.
struct Scene {
  std::string level;
  std::vector<Body> bodies;
  std::vector<SceneObject> objects;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();  ///< optical frame
  Eigen::Vector3d target = Eigen::Vector3d::Zero();                  ///< what the camera looks at, world frame
  std::vector<SceneBackground> background = {};
};

/// A camera at `eye` that looks at `target` and is not rolled: T_world_camera, optical frame.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

/// Frame 0..count-1 of a camera that starts at scene.T_world_camera and swings about the vertical through the scene's
/// target, at constant height and distance: kOrbitSwing_deg to the right, to the left and back to the start.
constexpr double kOrbitSwing_deg = 25;
Eigen::Isometry3d orbitPose(const Scene& scene, int frame, int count);

}  // namespace objectness::sim

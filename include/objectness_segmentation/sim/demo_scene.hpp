// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/sim/shapes.hpp"

namespace objectness::sim {

/// The built-in scene: a table over a floor, and on it three boxes, two cylinders and a bowl, some hidden by others in
/// part. The seed moves the objects a little (they never touch) and makes the noise. World frame: z up, origin on the
/// table.
std::vector<Body> demoBodies(std::uint32_t seed);

/// Where the demo's camera stands: T_world_camera.
Eigen::Isometry3d demoCameraPose();

/// The demo scene as the sensor sees it.
SceneImages makeDemoScene(std::uint32_t seed);

}  // namespace objectness::sim

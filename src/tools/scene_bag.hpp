// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "objectness_segmentation/common/status.hpp"
#include "sim/scene.hpp"
#include "tools/make_scene_options.hpp"

namespace objectness::sim {

/// Writes the scene to options.bag as a recording. index: of the scene, for the seed of its noise. Built without ROS it
/// is an error.
Status writeBag(const Scene& scene, std::uint32_t index, const MakeSceneOptions& options);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sim/simulated_frame.hpp"

namespace objectness::sim {

/// Writes a scene folder with objects.yaml (the truth) and pose.yaml (T_world_camera) in it.
Status saveSimulatedFrame(const std::string& folder, const SimulatedFrame& frame);

}  // namespace objectness::sim

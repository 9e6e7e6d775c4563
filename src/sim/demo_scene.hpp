// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "sim/scene.hpp"

namespace objectness::sim {

/// The built-in scene: a table over a floor, and on it three boxes, two cylinders and a bowl, some hidden by others in
/// part. The seed moves the objects a little (they never touch).
Scene makeDemoScene(std::uint32_t seed);

}  // namespace objectness::sim

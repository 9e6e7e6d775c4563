// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sim/arrangement.hpp"
#include "sim/surroundings.hpp"

namespace objectness::sim {

/// The bodies of what stands around (label kAroundLabel), clear of the table, of what stands on it and of the camera.
/// `room`: roomBodies() of area.table; its wall is moved back where it would stand in the way. Nothing when there is no
/// room for the arm over the things.
std::optional<std::vector<Body>> drawAround(const Surroundings& wanted, const Area& area,
                                            const std::vector<Placed>& things, std::vector<Body>& room, Random& random);

}  // namespace objectness::sim

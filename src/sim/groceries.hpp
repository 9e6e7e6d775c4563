// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "sim/household.hpp"

namespace objectness::sim {

/// What comes from the kitchen or the tool box: can, lying can, jar, packet, fruit, banana, open box, hammer,
/// screwdriver. By kind.
const std::map<std::string, Maker>& groceryMakers();

}  // namespace objectness::sim

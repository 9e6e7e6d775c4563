// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "sim/household.hpp"

namespace objectness::sim {

/// What is low and lies on a table: plate, pan, lid, knife, fork, spoon, marker, pen, book. By kind.
const std::map<std::string, Maker>& tablewareMakers();

}  // namespace objectness::sim

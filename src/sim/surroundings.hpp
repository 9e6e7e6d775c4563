// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/common/status.hpp"
#include "sim/random.hpp"

namespace objectness::sim {

/// What there is around the table besides the room. None of it is an object.
struct Surroundings {
  bool arm = false;    ///< of a robot, reaches in over the things
  bool wall = false;   ///< beside the table
  bool rack = false;   ///< with things in it, beside the table
  bool table = false;  ///< another one behind it, with things on it

  /// visit("arm", field) and so on for each of them.
  template <class Self, class Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("arm", self.arm);
    visit("wall", self.wall);
    visit("rack", self.rack);
    visit("table", self.table);
  }
};

/// "none", or what is wanted of arm, wall, rack and table: "arm,rack". kBadConfig: something else.
Result<Surroundings> parseSurroundings(const std::string& text);

/// Each is there in three of ten.
Surroundings drawSurroundings(Random& random);

}  // namespace objectness::sim

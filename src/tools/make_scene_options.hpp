// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "sim/depth_sensor.hpp"
#include "sim/room.hpp"
#include "sim/surroundings.hpp"

namespace objectness::sim {

/// What the command line of `make_scene` asks for.
struct MakeSceneOptions {
  std::vector<std::string> levels;  ///< empty: the demo scene
  std::optional<int> objects, count, frames;
  bool still = false;  ///< frames are of one view
  std::uint32_t seed = 1;
  std::optional<TableSize> table;
  std::optional<double> table_share;
  std::optional<Surroundings> around;
  DepthSensor sensor;
  std::string out, bag;  ///< folder and bag, one of them or both
  double rate_hz = 10;   ///< of the bag's frames
  std::string print;     ///< text to print instead of making anything (--help and the like)
};

/// An error is one that a look at `make_scene --help` helps with.
Result<MakeSceneOptions> parseMakeSceneOptions(int argc, const char* const* argv);

}  // namespace objectness::sim

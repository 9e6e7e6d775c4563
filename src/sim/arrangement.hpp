// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/levels.hpp"
#include "sim/room.hpp"
#include "sim/stage.hpp"
#include "sim/viewpoint.hpp"

namespace objectness::sim {

/// Where things are put: on the table within a disc, or on the floor of what stands on it; in view.
struct Area {
  TableSize table;
  std::optional<Stage> stage;
  Viewpoint viewpoint;
  PinholeCamera camera;
  double radius_m;  ///< about viewpoint.target, for what stands apart

  /// Whether a point is over the table and well within it, or in the room that the stage has.
  bool covers(const Eigen::Vector3d& point) const;
};

/// Puts down `count` things one after the other as the level asks. Fewer when there was no room for more, or none for
/// the second that makes the level what it is.
std::vector<Placed> arrange(const Level& level, int count, const Area& area, Random& random);

}  // namespace objectness::sim

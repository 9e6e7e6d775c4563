// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "sim/bodies.hpp"
#include "sim/levels.hpp"
#include "sim/room.hpp"

namespace objectness::sim {

/// A tray, tote or shelf that stands on the table; metres.
struct Stage {
  StageKind kind = StageKind::kTray;
  /// Centre of its floor, z up; the floor's top is the world's plane z = 0. The back of a shelf is at +y.
  Eigen::Isometry3d T_world_stage = Eigen::Isometry3d::Identity();
  Eigen::Vector2d half = Eigen::Vector2d::Zero();              ///< of the floor between the walls, along x and y
  double floor_m = 0;                                          ///< how high the floor's top is over the table
  double ceiling_m = std::numeric_limits<double>::infinity();  ///< the height over the floor that is free
  std::vector<Body> bodies;                                    ///< label kStageLabel

  /// Whether a point is in the room between its walls and its ceiling, at least this far from them.
  bool holds(const Eigen::Vector3d& point, double margin_m) const;
};

/// One with room for `count` things, somewhere on the table; nothing when the table is too small for it. `kind` is not
/// kTable. more_room: its floor is this many times as wide and deep as usual.
std::optional<Stage> drawStage(StageKind kind, int count, double more_room, const TableSize& table, Random& random);

}  // namespace objectness::sim

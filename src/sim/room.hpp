// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "sim/bodies.hpp"
#include "sim/random.hpp"

namespace objectness::sim {

struct TableSize {
  bool round = false;
  double width_m = 1.2, depth_m = 0.8;  ///< along x and y; of a round one both are the diameter
  double height_m = 0.72;               ///< of its top over the floor

  /// Whether a point lies over the top, at least this far from its edge; negative: how far beyond.
  bool covers(const Eigen::Vector2d& point, double margin_m) const;
};

/// "1.2x0.8x0.72" (width, depth, height) or "round:1.1x0.72" (diameter, height), metres.
Result<TableSize> parseTable(const std::string& text);

/// A coffee, dining or kitchen table.
TableSize drawTable(Random& random);

/// The table on its foot (the top has label 1), the floor below and a wall behind it (label 0). World frame: see Scene.
std::vector<Body> roomBodies(const TableSize& table, Random& random);

/// Moves the wall of roomBodies() back, unless it is farther away already, so that y_m is before it.
void moveWallBehind(std::vector<Body>& room, double y_m);

}  // namespace objectness::sim

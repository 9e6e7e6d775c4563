// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "sim/convex_bound.hpp"
#include "sim/household.hpp"

namespace objectness::sim {

/// A thing with its place in the world, whose table's top is z = 0.
struct Placed {
  Thing thing;
  Eigen::Isometry3d T_world_thing = Eigen::Isometry3d::Identity();
  bool upright = true;
  std::vector<ConvexBound> bounds;  ///< of its parts, in their order

  Eigen::Vector2d position() const { return T_world_thing.translation().head<2>(); }
  double top_z() const { return T_world_thing.translation().z() + thing.height(); }  ///< of what is upright
};

Placed place(const Thing& thing, const Eigen::Isometry3d& T_world_thing);
/// Upright, standing at height z.
Placed place(const Thing& thing, const Eigen::Vector2d& position, double z, double yaw);

/// No points of the two are nearer than this.
double gap(const Placed& a, const Placed& b);

/// Beside `neighbour` on the table, in the direction `angle` (from the world's x axis) from it and just so far that
/// their gap is gap_m.
Placed placeBeside(const Thing& thing, double yaw, const Placed& neighbour, double angle, double gap_m);

/// On the flat top of `support`, its centre well over it. Nothing when there is no such top, it
/// is too small, or the thing would roll off.
std::optional<Placed> placeOn(const Thing& thing, const Placed& support, Random& random);

/// A thing of the size of `support` on it, in line with it to the millimetre or to 3 mm. Nothing when it is none that
/// is stacked so, or the stack would be too high.
std::optional<Placed> placeFlush(const Placed& support, Random& random);

/// On the floor of the bowl, plate or pan that `support` is, clear of its wall. Nothing when it is none of these or has
/// no room for the thing; whether something else lies there is not looked at.
std::optional<Placed> placeWithin(const Thing& thing, const Placed& support, Random& random);

/// A slab whose lower edge stands on the table and which leans at a side of `support`: its face touches the support's
/// upper edge, or its upper edge the support's face when it is too short for that. It would not tip over to either
/// side. Nothing when the support has no upright side to lean at or the slab is too long.
std::optional<Placed> placeLeaning(const Thing& slab, const Placed& support, Random& random);

}  // namespace objectness::sim

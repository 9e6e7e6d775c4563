// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "segments/seen_thing.hpp"

namespace objectness {

/// A rectangle in the plan: low to high along its own axes, which are those of the table frame turned by the yaw.
struct PlanRectangle {
  double yaw_rad = 0;
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();

  double area() const { return (high - low).prod(); }
  Eigen::Vector2d toPlan(const Eigen::Vector2d& own) const;
  Eigen::Vector2d toOwn(const Eigen::Vector2d& plan) const;
};

/// What the normals of upright faces tell of their direction, modulo a quarter turn.
struct FaceDirection {
  double yaw_rad = 0;
  double agreement = 0;  ///< 0: any direction; 1: all faces are parallel or at right angles
  double weight = 0;     ///< share of the points that are upright, by how much they are
  double turn_deg = 90;  ///< 70 % of the normals are less far from a face's direction; 90 without any
};

FaceDirection faceDirection(const SeenThing& thing);

/// The rectangle of what is seen, without the foot of the thing where blurred edges reach far across the table. Its
/// yaw is that of the faces where they agree and make the rectangle hardly larger, otherwise that of the rectangle of
/// least area. Along faces it ends where their points do in numbers. thing: with points.
PlanRectangle seenRectangle(const SeenThing& thing, const FaceDirection& faces);

}  // namespace objectness

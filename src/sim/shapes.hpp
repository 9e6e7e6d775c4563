// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace objectness::sim {

/// Points origin + t * direction, t > 0; direction of any length.
struct Ray {
  Eigen::Vector3d origin, direction;

  Eigen::Vector3d at(double t) const { return origin + t * direction; }
};

struct Hit {
  double t = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, towards the ray's origin
};

// Solid shapes in frames of their own; metres.

/// Stands on z = 0, centred on the z axis.
struct Box {
  Eigen::Vector3d size;
};

/// A corner of a profile, and how the profile gets there from the corner before.
struct Corner {
  static constexpr double kStraight = std::numeric_limits<double>::quiet_NaN();

  double r, z;  ///< distance from the axis, height
  double sphere_z =
      kStraight;  ///< height of the centre of the sphere whose surface leads here; its centre is on the axis
};

/// A solid of revolution about the z axis. The profile leads from the axis at the bottom around the outside back to the
/// axis: at the top, or for what is open down along the inside again. See profiles.hpp for cylinders, bowls and such.
struct Revolution {
  std::vector<Corner> profile;
};

/// All points within `radius` of a chain of straight lines: a bent rod with round ends.
struct Tube {
  std::vector<Eigen::Vector3d> path;
  double radius;
};

using Shape = std::variant<Box, Revolution, Tube>;

/// Whether a point of the shape's own frame lies in its solid.
bool inside(const Shape& shape, const Eigen::Vector3d& point);

/// The smallest axis-aligned box about the shape, in its own frame.
Eigen::AlignedBox3d bounds(const Shape& shape);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/random.hpp"
#include "sim/shapes.hpp"

namespace objectness::sim {

/// A shape with its place in its thing. Turned by right angles only, so that its bounding box stays tight.
struct Part {
  Shape shape;
  Eigen::Isometry3d T_thing_part = Eigen::Isometry3d::Identity();

  template <class Solid, class = std::enable_if_t<std::is_constructible_v<Shape, Solid>>>
  Part(const Solid& solid) : shape(solid) {}  // NOLINT: a shape alone is a part that is not moved
  Part(const Shape& shape, const Eigen::Isometry3d& T_thing_part) : shape(shape), T_thing_part(T_thing_part) {}
};

/// Room in a bowl, plate or pan: a flat, round floor about the thing's axis. Over it the wall is a part of a sphere
/// about the axis or, where ball_radius is 0, nowhere nearer to the axis than at the floor.
struct Hollow {
  double floor_z = 0, floor_radius = 0, ball_z = 0, ball_radius = 0;
};

/// A household thing of 4 to 30 cm in a frame of its own: z up, standing on z = 0.
struct Thing {
  std::string kind;
  std::vector<Part> parts;  ///< the largest first
  /// The first part's bounding box or cylinder fits so well that what is put beside it touches the thing itself.
  bool tight_sides = false;
  /// Half the width and depth of the flat top that can carry something; 0 when there is none.
  Eigen::Vector2d top_half = Eigen::Vector2d::Zero();

  std::optional<Hollow> hollow = std::nullopt;

  Eigen::AlignedBox3d box() const;  ///< about all parts
  double height() const { return box().max().z(); }
};

using Maker = Thing (*)(Random&);

/// A thing of random size: a box, cylinder, cone, sphere, bowl, mug or bottle, or of tablewareMakers() or
/// groceryMakers().
Thing makeThing(const std::string& kind, Random& random);

/// Half the width and depth of the widest square in the flat round top of a thing.
Eigen::Vector2d squareIn(double top_radius);

/// T_thing_part of a part that is moved and not turned.
inline Eigen::Isometry3d moved(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A board or book that can lean, thin in y and long in z.
Thing makeSlab(Random& random);

/// BGR: not dark, not grey.
cv::Vec3b drawColor(Random& random);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace objectness::sim {

/// Points origin + t * direction, t > 0; direction of any length.
struct Ray {
  Eigen::Vector3d origin, direction;
};

struct Hit {
  double t = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, towards the ray's origin
};

// Shapes stand on z = 0 of their own frame, centred on its z axis; metres.

struct Box {
  Eigen::Vector3d size;
};

/// Closed at both ends.
struct Cylinder {
  double radius, height;
};

/// Open at the top: what lies between two spheres about a centre on the z axis, cut off at the rim and flat at the
/// foot.
struct Bowl {
  double radius, height, thickness;  ///< of the outer sphere; of the rim over the foot; of the wall
  double centre_z;                   ///< of both spheres; less than radius, so that the foot is flat
};

using Shape = std::variant<Box, Cylinder, Bowl>;

/// The first point of the shape's surface on the ray, in the shape's own frame.
std::optional<Hit> intersect(const Box& box, const Ray& ray);
std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray);
std::optional<Hit> intersect(const Bowl& bowl, const Ray& ray);

/// A shape in the world.
struct Body {
  Shape shape;
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  cv::Vec3b color;   ///< BGR
  ushort label = 0;  ///< in true label images: 0 void, 1 table, 20, 30, ... objects
};

struct SceneHit {
  Hit hit;  ///< world frame
  const Body* body = nullptr;
};

/// The first body on a ray of the world frame; body is null when there is none.
SceneHit castRay(const std::vector<Body>& bodies, const Ray& ray);

/// Whether anything lies between two points of the world frame.
bool isBlocked(const std::vector<Body>& bodies, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "sim/intersect.hpp"
#include "sim/shapes.hpp"

namespace objectness::sim {

/// A shape in the world.
struct Body {
  Shape shape;
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  cv::Vec3b color;   ///< BGR
  ushort label = 0;  ///< in true label images: 0 void, 1 table, 20, 30, ... objects; an object may have several bodies
};

struct SceneHit {
  Hit hit;  ///< world frame
  const Body* body = nullptr;
};

/// Casts rays of the world frame into bodies, which must outlive it. Safe to share between threads.
class RayCaster {
 public:
  explicit RayCaster(const std::vector<Body>& bodies);

  /// The first body on the ray; body is null when there is none.
  SceneHit first(const Ray& ray) const;

  /// The same, and calls visit(body) for each body that the ray hits anywhere, in their order.
  template <class Visit>
  SceneHit first(const Ray& ray, Visit&& visit) const {
    SceneHit nearest;
    for (const Placed& placed : placed_) {
      if (!placed.near(ray)) continue;
      const std::optional<Hit> hit = placed.cast(ray);
      if (!hit) continue;
      visit(*placed.body);
      if (!nearest.body || hit->t < nearest.hit.t) nearest = {*hit, placed.body};
    }
    if (nearest.body) nearest.hit.normal = nearest.body->T_world_body.linear() * nearest.hit.normal;
    return nearest;
  }

  /// Whether anything lies between two points.
  bool isBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  struct Placed {
    const Body* body;
    Eigen::Matrix3d R_body_world;
    Eigen::Vector3d t_body_world, centre;  ///< of the bounding sphere, world frame
    double squared_radius;

    /// False when the ray misses the bounding sphere.
    bool near(const Ray& ray) const {
      const Eigen::Vector3d to_centre = centre - ray.origin;
      return to_centre.cross(ray.direction).squaredNorm() <= squared_radius * ray.direction.squaredNorm();
    }
    /// The hit in the body's frame.
    std::optional<Hit> cast(const Ray& ray) const {
      return intersect(body->shape, {R_body_world * ray.origin + t_body_world, R_body_world * ray.direction});
    }
  };
  std::vector<Placed> placed_;
};

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/sim/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

// Keeps a ray that starts on a surface from hitting that surface again.
constexpr double kMinT = 1e-9;
// Shadow rays end this far before the point they are sent to, as a share of their length.
constexpr double kShadowSlack = 1e-4;

Vector3d at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

/// Keeps the nearest of the candidates that are offered.
struct Nearest {
  const Ray& ray;
  std::optional<Hit> hit;

  void offer(double t, const Vector3d& normal) {
    if (!(t > kMinT) || (hit && hit->t <= t)) return;
    hit = Hit{t, normal.dot(ray.direction) > 0 ? Vector3d(-normal) : normal};
  }
};

/// Both solutions of a t^2 + 2 b t + c = 0, NaN when there is none.
std::pair<double, double> roots(double a, double b, double c) {
  const double root = std::sqrt(b * b - a * c);
  return {(-b - root) / a, (-b + root) / a};
}

/// The ring at height z between two radii.
void offerRing(double z, double inner, double outer, Nearest& nearest) {
  const double t = (z - nearest.ray.origin.z()) / nearest.ray.direction.z();
  const double r = at(nearest.ray, t).head<2>().norm();
  if (r >= inner && r <= outer) nearest.offer(t, Vector3d::UnitZ());
}

/// The part of a sphere about (0, 0, centre_z) between two heights.
void offerSphere(double centre_z, double radius, double low, double high, Nearest& nearest) {
  const Vector3d centre(0, 0, centre_z), o = nearest.ray.origin - centre, &d = nearest.ray.direction;
  const auto [first, second] = roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - radius * radius);
  for (const double t : {first, second}) {
    const Vector3d p = at(nearest.ray, t);
    if (p.z() >= low && p.z() <= high) nearest.offer(t, (p - centre) / radius);
  }
}

double radiusAt(double sphere_radius, double height_over_centre) {
  return std::sqrt(std::max(0.0, sphere_radius * sphere_radius - height_over_centre * height_over_centre));
}

}  // namespace

std::optional<Hit> intersect(const Box& box, const Ray& ray) {
  Nearest nearest{ray, {}};
  const Vector3d low(-box.size.x() / 2, -box.size.y() / 2, 0), high = low + box.size;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {low[axis], high[axis]}) {
      const double t = (side - ray.origin[axis]) / ray.direction[axis];
      Vector3d p = at(ray, t);
      p[axis] = side;  // exactly, whatever the rounding
      if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all()) nearest.offer(t, Vector3d::Unit(axis));
    }
  }
  return nearest.hit;
}

std::optional<Hit> intersect(const Cylinder& cylinder, const Ray& ray) {
  Nearest nearest{ray, {}};
  const auto o = ray.origin.head<2>(), d = ray.direction.head<2>();
  const auto [first, second] = roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - cylinder.radius * cylinder.radius);
  for (const double t : {first, second}) {
    const Vector3d p = at(ray, t);
    if (p.z() >= 0 && p.z() <= cylinder.height) nearest.offer(t, Vector3d(p.x(), p.y(), 0) / cylinder.radius);
  }
  offerRing(0, 0, cylinder.radius, nearest);
  offerRing(cylinder.height, 0, cylinder.radius, nearest);
  return nearest.hit;
}

std::optional<Hit> intersect(const Bowl& bowl, const Ray& ray) {
  Nearest nearest{ray, {}};
  const double inner = bowl.radius - bowl.thickness, rim = bowl.height - bowl.centre_z;
  offerSphere(bowl.centre_z, bowl.radius, 0, bowl.height, nearest);
  offerSphere(bowl.centre_z, inner, bowl.thickness, bowl.height, nearest);
  offerRing(bowl.height, radiusAt(inner, rim), radiusAt(bowl.radius, rim), nearest);
  offerRing(0, 0, radiusAt(bowl.radius, bowl.centre_z), nearest);
  offerRing(bowl.thickness, 0, radiusAt(inner, bowl.thickness - bowl.centre_z), nearest);
  return nearest.hit;
}

SceneHit castRay(const std::vector<Body>& bodies, const Ray& ray) {
  SceneHit nearest;
  for (const Body& body : bodies) {
    const Eigen::Isometry3d T_body_world = body.T_world_body.inverse();
    const Ray local{T_body_world * ray.origin, T_body_world.linear() * ray.direction};
    const auto hit = std::visit([&](const auto& shape) { return intersect(shape, local); }, body.shape);
    if (hit && (!nearest.body || hit->t < nearest.hit.t)) {
      nearest = {{hit->t, body.T_world_body.linear() * hit->normal}, &body};
    }
  }
  return nearest;
}

bool isBlocked(const std::vector<Body>& bodies, const Vector3d& from, const Vector3d& to) {
  const SceneHit seen = castRay(bodies, {from, to - from});
  return seen.body && seen.hit.t < 1 - kShadowSlack;
}

}  // namespace objectness::sim

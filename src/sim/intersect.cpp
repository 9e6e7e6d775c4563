// SPDX-License-Identifier: BSD-3-Clause
#include "sim/intersect.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

// Keeps a ray that starts on a surface from hitting that surface again.
constexpr double kMinT = 1e-9;
// The pieces of a surface reach this far over their ends, so that rounding leaves no pinhole at a seam or at a pole.
constexpr double kSeam_m = 1e-12;

bool isBetween(double value, double a, double b) {
  return value >= std::min(a, b) - kSeam_m && value <= std::max(a, b) + kSeam_m;
}

/// Keeps the nearest of the candidates that are offered.
struct Nearest {
  const Ray& ray;
  std::optional<Hit> hit;

  void offer(double t, const Vector3d& normal) {
    if (!(t > kMinT) || (hit && hit->t <= t)) return;
    hit = Hit{t, normal.dot(ray.direction) > 0 ? Vector3d(-normal) : normal};
  }
};

/// The solutions of a t^2 + 2 b t + c = 0 in the form that loses no digits, NaN or infinite where there is none; a may
/// be 0.
std::array<double, 2> roots(double a, double b, double c) {
  const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
  return {q / a, c / q};
}

/// The ring at height z between two radii.
void offerRing(double z, double r1, double r2, Nearest& nearest) {
  const double t = (z - nearest.ray.origin.z()) / nearest.ray.direction.z();
  const double r = nearest.ray.at(t).head<2>().norm();
  if (isBetween(r, r1, r2)) nearest.offer(t, Vector3d::UnitZ());
}

/// The part of a sphere between two heights.
void offerSphere(const Vector3d& centre, double radius, double z1, double z2, Nearest& nearest) {
  const Vector3d o = nearest.ray.origin - centre, &d = nearest.ray.direction;
  for (const double t : roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - radius * radius)) {
    const Vector3d p = nearest.ray.at(t);
    if (isBetween(p.z(), z1, z2)) nearest.offer(t, (p - centre) / radius);
  }
}

/// The part of a cone or cylinder about the z axis between two corners of its profile.
void offerCone(const Corner& from, const Corner& to, Nearest& nearest) {
  const Ray& ray = nearest.ray;
  const double slope = (to.r - from.r) / (to.z - from.z);  // of the radius over the height
  const double r = from.r + slope * (ray.origin.z() - from.z), dr = slope * ray.direction.z();
  const auto o = ray.origin.head<2>(), d = ray.direction.head<2>();
  for (const double t : roots(d.squaredNorm() - dr * dr, o.dot(d) - r * dr, o.squaredNorm() - r * r)) {
    const Vector3d p = ray.at(t);
    if (!isBetween(p.z(), from.z, to.z)) continue;
    const double distance = p.head<2>().norm();
    if (distance == 0) continue;  // the tip itself has no normal; the rays beside it do
    nearest.offer(t, Vector3d(p.x() / distance, p.y() / distance, -slope).normalized());
  }
}

/// The side of a cylinder between two points of its axis.
void offerRod(const Vector3d& from, const Vector3d& to, double radius, Nearest& nearest) {
  const Ray& ray = nearest.ray;
  const double length = (to - from).norm();
  const Vector3d axis = (to - from) / length, o = ray.origin - from;
  const Vector3d o_across = o - o.dot(axis) * axis, d_across = ray.direction - ray.direction.dot(axis) * axis;
  for (const double t :
       roots(d_across.squaredNorm(), o_across.dot(d_across), o_across.squaredNorm() - radius * radius)) {
    const double along = (ray.at(t) - from).dot(axis);
    if (isBetween(along, 0, length)) nearest.offer(t, (o_across + t * d_across) / radius);
  }
}

void offer(const Box& box, Nearest& nearest) {
  const Ray& ray = nearest.ray;
  const Vector3d low(-box.size.x() / 2, -box.size.y() / 2, 0), high = low + box.size;
  double t_in = -std::numeric_limits<double>::infinity(), t_out = -t_in;
  int axis_in = 0, axis_out = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return;
      continue;
    }
    const double a = (low[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (high[axis] - ray.origin[axis]) / ray.direction[axis];
    if (std::min(a, b) > t_in) t_in = std::min(a, b), axis_in = axis;
    if (std::max(a, b) < t_out) t_out = std::max(a, b), axis_out = axis;
  }
  if (t_in > t_out) return;
  nearest.offer(t_in, Vector3d::Unit(axis_in));
  nearest.offer(t_out, Vector3d::Unit(axis_out));
}

void offer(const Revolution& solid, Nearest& nearest) {
  for (std::size_t i = 1; i < solid.profile.size(); ++i) {
    const Corner &from = solid.profile[i - 1], &to = solid.profile[i];
    if (!std::isnan(to.sphere_z)) {
      offerSphere({0, 0, to.sphere_z}, std::hypot(to.r, to.z - to.sphere_z), from.z, to.z, nearest);
    } else if (from.z == to.z) {
      offerRing(to.z, from.r, to.r, nearest);
    } else {
      offerCone(from, to, nearest);
    }
  }
}

void offer(const Tube& tube, Nearest& nearest) {
  constexpr double kEverywhere = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tube.path.size(); ++i) {
    offerSphere(tube.path[i], tube.radius, -kEverywhere, kEverywhere, nearest);
    if (i > 0) offerRod(tube.path[i - 1], tube.path[i], tube.radius, nearest);
  }
}

}  // namespace

std::optional<Hit> intersect(const Shape& shape, const Ray& ray) {
  Nearest nearest{ray, {}};
  std::visit([&](const auto& s) { offer(s, nearest); }, shape);
  return nearest.hit;
}

}  // namespace objectness::sim

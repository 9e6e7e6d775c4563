// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace objectness::sim {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// The profile's distance from the axis at a height between two corners.
double radiusAt(const Corner& from, const Corner& to, double z) {
  if (std::isnan(to.sphere_z)) return from.r + (to.r - from.r) * (z - from.z) / (to.z - from.z);
  const double radius = std::hypot(to.r, to.z - to.sphere_z), over_centre = z - to.sphere_z;
  return std::sqrt(std::max(0.0, radius * radius - over_centre * over_centre));
}

bool contains(const Box& box, const Vector3d& p) {
  return std::abs(p.x()) <= box.size.x() / 2 && std::abs(p.y()) <= box.size.y() / 2 && p.z() >= 0 &&
         p.z() <= box.size.z();
}

/// Outwards from the point, away from the axis, an odd number of surfaces is crossed.
bool contains(const Revolution& solid, const Vector3d& p) {
  const double r = p.head<2>().norm();
  bool odd = false;
  for (std::size_t i = 1; i < solid.profile.size(); ++i) {
    const Corner &from = solid.profile[i - 1], &to = solid.profile[i];
    if ((from.z <= p.z()) != (to.z <= p.z()) && radiusAt(from, to, p.z()) > r) odd = !odd;
  }
  return odd;
}

bool contains(const Tube& tube, const Vector3d& p) {
  for (std::size_t i = 1; i < tube.path.size(); ++i) {
    const Vector3d along = tube.path[i] - tube.path[i - 1];
    const double share = std::clamp((p - tube.path[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    if ((tube.path[i - 1] + share * along - p).squaredNorm() <= tube.radius * tube.radius) return true;
  }
  return false;
}

AlignedBox3d boundsOf(const Box& box) {
  const Vector3d half(box.size.x() / 2, box.size.y() / 2, 0);
  return {Vector3d(-half), Vector3d(half + Vector3d(0, 0, box.size.z()))};
}

AlignedBox3d boundsOf(const Revolution& solid) {
  AlignedBox3d box;
  for (std::size_t i = 0; i < solid.profile.size(); ++i) {
    const Corner& to = solid.profile[i];
    double r = to.r;
    if (i > 0 && !std::isnan(to.sphere_z)) {
      const auto [low, high] = std::minmax(solid.profile[i - 1].z, to.z);
      if (low < to.sphere_z && to.sphere_z < high) r = std::hypot(to.r, to.z - to.sphere_z);
    }
    box.extend(Vector3d(r, r, to.z));
    box.extend(Vector3d(-r, -r, to.z));
  }
  return box;
}

AlignedBox3d boundsOf(const Tube& tube) {
  AlignedBox3d box;
  for (const Vector3d& p : tube.path) {
    box.extend(p + Vector3d::Constant(tube.radius));
    box.extend(p - Vector3d::Constant(tube.radius));
  }
  return box;
}

}  // namespace

bool inside(const Shape& shape, const Vector3d& point) {
  return std::visit([&](const auto& s) { return contains(s, point); }, shape);
}

AlignedBox3d bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return boundsOf(s); }, shape);
}

}  // namespace objectness::sim

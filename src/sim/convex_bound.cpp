// SPDX-License-Identifier: BSD-3-Clause
#include "sim/convex_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kShortest = 1e-9;  // a candidate axis shorter than this has no direction

/// The part of `v` across the bound's own z axis.
Vector3d acrossAxis(const ConvexBound& bound, const Vector3d& v) {
  const Vector3d axis = bound.T_world_centre.linear().col(2);
  return v - v.dot(axis) * axis;
}

}  // namespace

std::array<Vector3d, 8> ConvexBound::corners() const {
  std::array<Vector3d, 8> all;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    all[i] = T_world_centre * Vector3d(sign.cwiseProduct(half));
  }
  return all;
}

double ConvexBound::reach(const Vector3d& direction) const {
  const Vector3d local = T_world_centre.linear().transpose() * direction;
  if (!round) return local.cwiseAbs().dot(half);
  return local.head<2>().norm() * half.x() + std::abs(local.z()) * half.z();
}

double separation(const ConvexBound& a, const ConvexBound& b) {
  const Vector3d apart = b.T_world_centre.translation() - a.T_world_centre.translation();
  double widest = -std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vector3d& axis) {
    const double length = axis.norm();
    if (length < kShortest) return;
    const Vector3d n = axis / length;
    widest = std::max(widest, std::abs(apart.dot(n)) - a.reach(n) - b.reach(n));
  };
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = a.T_world_centre.linear().col(i);
    offer(axis);
    offer(b.T_world_centre.linear().col(i));
    for (int k = 0; k < 3; ++k) offer(axis.cross(b.T_world_centre.linear().col(k)));
  }
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    if (!one->round) continue;
    offer(acrossAxis(*one, apart));
    for (const Vector3d& corner : other->corners()) {
      if (!other->round) offer(acrossAxis(*one, corner - one->T_world_centre.translation()));
    }
  }
  return widest;
}

}  // namespace objectness::sim

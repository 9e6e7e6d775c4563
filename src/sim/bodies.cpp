// SPDX-License-Identifier: BSD-3-Clause
#include "sim/bodies.hpp"

namespace objectness::sim {
namespace {

// Rays to a point end this far before it, as a share of their length.
constexpr double kSlack = 1e-4;

}  // namespace

RayCaster::RayCaster(const std::vector<Body>& bodies) {
  for (const Body& body : bodies) {
    const Eigen::AlignedBox3d box = bounds(body.shape);
    const Eigen::Isometry3d T_body_world = body.T_world_body.inverse();
    placed_.push_back({&body, T_body_world.linear(), T_body_world.translation(), body.T_world_body * box.center(),
                       box.diagonal().squaredNorm() / 4 * (1 + 1e-9)});
  }
}

SceneHit RayCaster::first(const Ray& ray) const {
  return first(ray, [](const Body&) {});
}

bool RayCaster::isBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const Ray ray{from, to - from};
  for (const Placed& placed : placed_) {
    if (!placed.near(ray)) continue;
    const std::optional<Hit> hit = placed.cast(ray);
    if (hit && hit->t < 1 - kSlack) return true;
  }
  return false;
}

}  // namespace objectness::sim

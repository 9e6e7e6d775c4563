// SPDX-License-Identifier: BSD-3-Clause
#include "sim/viewpoint.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"
#include "sim/scene.hpp"
#include "sim/scene_generator.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kTargetHeight_m = 0.05;
constexpr double kNearest_m = 0.45;  // of a thing to the camera, along the optical axis
constexpr double kImageMargin_px = 4;

}  // namespace

double Viewpoint::bearing(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d away = point - T_world_camera.translation().head<2>();
  return std::atan2(away.y(), away.x());
}

Viewpoint drawViewpoint(const Eigen::Vector2d& target, double radius_m, const ViewRange& range,
                        const PinholeCamera& camera, Random& random) {
  const double half_view = std::min(camera.width / (2 * camera.fx), 1.2 * camera.height / (2 * camera.fy));
  const double nearest = std::clamp(1.1 * radius_m / half_view, kMinDistance_m, kMaxDistance_m);
  const double distance = random.uniform(nearest, kMaxDistance_m);
  const double tilt = random.uniform(range.min_tilt_deg, range.max_tilt_deg) * kPi / 180;
  // The turn is from the table's own front, so that the wall stays behind the table.
  const double turn = random.uniform(-range.max_turn_deg, range.max_turn_deg) * kPi / 180;
  const double roll = random.uniform(-range.max_roll_deg, range.max_roll_deg) * kPi / 180;
  Viewpoint viewpoint;
  viewpoint.target = {target.x(), target.y(), kTargetHeight_m};
  const Vector3d back(std::sin(turn) * std::cos(tilt), -std::cos(turn) * std::cos(tilt), std::sin(tilt));
  viewpoint.T_world_camera = lookAt(viewpoint.target + distance * back, viewpoint.target);
  viewpoint.T_world_camera.rotate(Eigen::AngleAxisd(roll, Vector3d::UnitZ()));
  return viewpoint;
}

std::optional<Viewpoint> givenViewpoint(const Eigen::Isometry3d& T_world_camera) {
  const Vector3d eye = T_world_camera.translation(), forward = T_world_camera.linear().col(2);
  const double t = (kTargetHeight_m - eye.z()) / forward.z();
  if (!(t > 0 && forward.z() < 0)) return {};
  return Viewpoint{T_world_camera, eye + t * forward};
}

bool isInView(const Placed& placed, const Viewpoint& viewpoint, const PinholeCamera& camera) {
  const Eigen::Isometry3d T_camera_world = viewpoint.T_world_camera.inverse();
  for (const ConvexBound& bound : placed.bounds) {
    for (const Vector3d& corner : bound.corners()) {
      const Vector3d p = T_camera_world * corner;
      if (p.z() < kNearest_m) return false;
      const Eigen::Vector2d pixel = camera.project(p);
      if (pixel.x() < kImageMargin_px || pixel.x() > camera.width - 1 - kImageMargin_px ||
          pixel.y() < kImageMargin_px || pixel.y() > camera.height - 1 - kImageMargin_px) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace objectness::sim

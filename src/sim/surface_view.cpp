// SPDX-License-Identifier: BSD-3-Clause
#include "sim/surface_view.hpp"

#include <algorithm>

#include "common/parallel.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kAmbientLight = 0.45;
const Vector3d kTowardsLight = Vector3d(0.3, -0.5, 0.8).normalized();  // world frame

cv::Vec3b shade(const cv::Vec3b& color, const Vector3d& normal) {
  const double light = kAmbientLight + (1 - kAmbientLight) * std::max(0.0, normal.dot(kTowardsLight));
  return color * light;
}

}  // namespace

SurfaceView viewSurfaces(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                         const PinholeCamera& camera, const std::optional<Vector3d>& projector, int threads) {
  SurfaceView view{camera, {}, cv::Mat_<cv::Vec3b>(camera.height, camera.width, cv::Vec3b(0, 0, 0)), {}, {}};
  view.pixels.resize(static_cast<std::size_t>(camera.width) * camera.height);
  const RayCaster caster(bodies);
  const Eigen::Matrix3d R_camera_world = T_world_camera.linear().transpose();
  int labels = 0;
  for (const Body& body : bodies) labels = std::max(labels, body.label + 1);
  cv::Mat_<int> seen(camera.height, labels, 0), alone(camera.height, labels, 0);  // by row, then label
  parallelFor(camera.height, threads, [&](int v) {
    for (int u = 0; u < camera.width; ++u) {
      const Ray ray{T_world_camera.translation(), T_world_camera.linear() * camera.ray(u, v)};  // its t is the depth
      int last_label = -1;  // the bodies of one object follow each other
      const SceneHit first = caster.first(ray, [&](const Body& body) {
        if (body.label != last_label) ++alone(v, body.label);
        last_label = body.label;
      });
      if (!first.body) continue;
      ++seen(v, first.body->label);
      view.color(v, u) = shade(first.body->color, first.hit.normal);
      const bool lit = !projector || !caster.isBlocked(T_world_camera * *projector, ray.at(first.hit.t));
      view.pixels[static_cast<std::size_t>(v) * camera.width + u] = {first.body, first.hit.t,
                                                                     R_camera_world * first.hit.normal, lit};
    }
  });
  for (const Body& body : bodies) {
    view.pixels_seen[body.label] = static_cast<int>(cv::sum(seen.col(body.label))[0]);
    view.pixels_alone[body.label] = static_cast<int>(cv::sum(alone.col(body.label))[0]);
  }
  return view;
}

}  // namespace objectness::sim

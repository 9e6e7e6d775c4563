// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/sim/depth_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kAmbientLight = 0.45;
const Vector3d kTowardsLight = Vector3d(0.3, -0.5, 0.8).normalized();  // world frame

/// Gaussian (Box and Muller); the standard library's gives other numbers on every platform.
double gaussian(std::mt19937& random) {
  const double radius = std::sqrt(-2 * std::log((random() + 1.0) / 4294967296.0));
  return radius * std::cos(2 * kPi * random() / 4294967296.0);
}

/// Noise of unit deviation, equal to the mean of its 3 x 3 neighbourhood up to scale.
cv::Mat_<double> smoothNoise(cv::Size size, std::uint32_t seed) {
  std::mt19937 random(seed);
  cv::Mat_<double> white(size.height + 2, size.width + 2), smooth(size, 0.0);
  for (double& value : white) value = gaussian(random);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      for (int i = 0; i < 9; ++i) smooth(v, u) += white(v + i / 3, u + i % 3) / 3;  // deviation of nine added: 3
    }
  }
  return smooth;
}

cv::Vec3b shade(const cv::Vec3b& color, const Vector3d& normal) {
  const double light = kAmbientLight + (1 - kAmbientLight) * std::max(0.0, normal.dot(kTowardsLight));
  return color * light;
}

/// The measured depth, 0 when there is none.
double measure(const DepthSensor& sensor, double z, double noise) {
  const double noisy = z + sensor.sigma(z) * noise;
  const double per_depth = sensor.camera.fx * sensor.baseline_m / sensor.disparity_step_px;  // steps at 1 m
  const double stepped = per_depth / std::round(per_depth / noisy);
  return stepped >= sensor.min_depth_m && stepped <= sensor.max_depth_m ? stepped : 0;
}

}  // namespace

SceneImages takePicture(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                        const DepthSensor& sensor, std::uint32_t seed) {
  const PinholeCamera& camera = sensor.camera;
  const cv::Size size(camera.width, camera.height);
  SceneImages picture{camera, cv::Mat_<ushort>(size, ushort{0}), cv::Mat_<cv::Vec3b>(size, cv::Vec3b(0, 0, 0)),
                      cv::Mat_<ushort>(size, ushort{0})};
  const cv::Mat_<double> noise = smoothNoise(size, seed);
  const Vector3d eye = T_world_camera.translation();
  const Vector3d projector = T_world_camera * Vector3d(sensor.baseline_m, 0, 0);
  const double min_cosine = std::cos(sensor.max_incidence_deg * kPi / 180);

  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Ray ray{eye, T_world_camera.linear() * camera.ray(u, v)};  // its t is the depth
      const SceneHit seen = castRay(bodies, ray);
      if (!seen.body) continue;
      picture.color(v, u) = shade(seen.body->color, seen.hit.normal);
      const Vector3d point = eye + seen.hit.t * ray.direction;
      const double cosine = -seen.hit.normal.dot(ray.direction.normalized());
      if (cosine < min_cosine || isBlocked(bodies, projector, point)) continue;
      const double depth_m = measure(sensor, seen.hit.t, noise(v, u));
      if (depth_m == 0) continue;
      picture.depth_mm(v, u) = static_cast<ushort>(std::lround(depth_m * 1000));
      picture.true_labels(v, u) = seen.body->label;
    }
  }
  return picture;
}

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/sim/demo_scene.hpp"

#include <random>

#include "objectness_segmentation/sim/depth_sensor.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kTableHeight_m = 0.72, kTableThickness_m = 0.03;
constexpr double kJitter_m = 0.008, kJitter_deg = 6;  // small enough for the gaps between the objects

Body place(const Shape& shape, double x, double y, double z, double yaw_deg, const cv::Vec3b& color, int label) {
  Body body{shape, Eigen::Isometry3d::Identity(), color, static_cast<ushort>(label)};
  body.T_world_body.translate(Vector3d(x, y, z)).rotate(Eigen::AngleAxisd(yaw_deg * kPi / 180, Vector3d::UnitZ()));
  return body;
}

}  // namespace

std::vector<Body> demoBodies(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto jitter = [&](double most) { return most * (2 * (random() / 4294967296.0) - 1); };
  std::vector<Body> bodies{
      place(Box{{6, 6, 0.01}}, 0, 1, -kTableHeight_m - 0.01, 0, {96, 90, 84}, 0),  // the floor
      place(Box{{1.2, 0.8, kTableThickness_m}}, 0, 0.05, -kTableThickness_m, 0, {120, 160, 190}, 1),
  };
  struct Item {
    Shape shape;
    double x, y, yaw_deg;
    cv::Vec3b color;
  };
  const std::vector<Item> items{
      {Box{{0.19, 0.065, 0.24}}, -0.22, 0.20, 25, {40, 110, 220}},  // cereals
      {Box{{0.16, 0.11, 0.07}}, -0.02, 0.13, -15, {190, 120, 50}},  // partly behind the can
      {Box{{0.10, 0.07, 0.05}}, -0.27, -0.08, 40, {70, 170, 80}},
      {Cylinder{0.034, 0.122}, 0.075, 0.0, 0, {50, 50, 200}},   // can
      {Cylinder{0.045, 0.20}, 0.30, 0.24, 0, {190, 190, 200}},  // jar
      {Bowl{0.09, 0.05, 0.005, 0.08}, 0.25, -0.03, 0, {200, 180, 90}},
  };
  for (const Item& item : items) {
    const double x = item.x + jitter(kJitter_m), y = item.y + jitter(kJitter_m),
                 yaw = item.yaw_deg + jitter(kJitter_deg);
    bodies.push_back(place(item.shape, x, y, 0, yaw, item.color, 20 + 10 * static_cast<int>(bodies.size() - 2)));
  }
  return bodies;
}

Eigen::Isometry3d demoCameraPose() {
  const Vector3d eye(0.02, -0.64, 0.62), target(0, 0.08, 0.04);
  const Vector3d forward = (target - eye).normalized(), right = forward.cross(Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() = eye;
  return pose;
}

SceneImages makeDemoScene(std::uint32_t seed) {
  return takePicture(demoBodies(seed), demoCameraPose(), DepthSensor(), seed);
}

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/demo_scene.hpp"

#include "common/angles.hpp"
#include "common/true_labels.hpp"
#include "sim/profiles.hpp"
#include "sim/random.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kTableHeight_m = 0.72, kTableThickness_m = 0.03;
constexpr double kJitter_m = 0.008, kJitter_deg = 6;  // small enough for the gaps between the objects

Body place(const Shape& shape, double x, double y, double z, double yaw_deg, const cv::Vec3b& color, int label) {
  Body body{shape, Eigen::Isometry3d::Identity(), color, static_cast<ushort>(label)};
  body.T_world_body.translate(Vector3d(x, y, z)).rotate(Eigen::AngleAxisd(yaw_deg * kPi / 180, Vector3d::UnitZ()));
  return body;
}

}  // namespace

Scene makeDemoScene(std::uint32_t seed) {
  Random random(seed);
  Scene scene;
  scene.level = "demo";
  scene.bodies = {
      place(Box{{6, 6, 0.01}}, 0, 1, -kTableHeight_m - 0.01, 0, {96, 90, 84}, 0),  // the floor
      place(cylinder(0.05, kTableHeight_m - kTableThickness_m), 0, 0.05, -kTableHeight_m, 0, {120, 160, 190}, 0),
      place(Box{{1.2, 0.8, kTableThickness_m}}, 0, 0.05, -kTableThickness_m, 0, {120, 160, 190}, 1),
  };
  struct Item {
    const char* kind;
    Shape shape;
    double x, y, yaw_deg;
    cv::Vec3b color;
  };
  const std::vector<Item> items{
      {"box", Box{{0.19, 0.065, 0.24}}, -0.22, 0.20, 25, {40, 110, 220}},  // cereals
      {"box", Box{{0.16, 0.11, 0.07}}, -0.02, 0.13, -15, {190, 120, 50}},  // partly behind the can
      {"box", Box{{0.10, 0.07, 0.05}}, -0.27, -0.08, 40, {70, 170, 80}},
      {"cylinder", cylinder(0.034, 0.122), 0.075, 0.0, 0, {50, 50, 200}},   // can
      {"cylinder", cylinder(0.045, 0.20), 0.30, 0.24, 0, {190, 190, 200}},  // jar
      {"bowl", bowl(0.09, 0.05, 0.005, 0.08), 0.25, -0.03, 0, {200, 180, 90}},
  };
  for (const Item& item : items) {
    const double x = item.x + random.uniform(-kJitter_m, kJitter_m);
    const double y = item.y + random.uniform(-kJitter_m, kJitter_m);
    const double yaw_deg = item.yaw_deg + random.uniform(-kJitter_deg, kJitter_deg);
    const int label = trueLabel(scene.objects.size());
    const Body body = place(item.shape, x, y, 0, yaw_deg, item.color, label);
    const Eigen::AlignedBox3d box = bounds(item.shape);
    scene.bodies.push_back(body);
    scene.objects.push_back({item.kind, label, body.T_world_body * Eigen::Translation3d(box.center()), box.sizes()});
  }
  scene.target = {0, 0.08, 0.04};
  scene.T_world_camera = lookAt({0.02, -0.64, 0.62}, scene.target);
  return scene;
}

}  // namespace objectness::sim

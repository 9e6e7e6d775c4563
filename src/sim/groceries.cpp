// SPDX-License-Identifier: BSD-3-Clause
#include "sim/groceries.hpp"

#include <cmath>

#include "common/angles.hpp"
#include "sim/profiles.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

Thing drawCan(Random& random) {
  const double radius = random.uniform(0.026, 0.045), height = random.uniform(0.035, 0.12);
  return {"can", {cylinder(radius, height)}, true, squareIn(radius)};
}

/// A can on its side, its axis along x.
Thing drawLyingCan(Random& random) {
  const double radius = random.uniform(0.026, 0.045), height = random.uniform(0.06, 0.14);
  const Eigen::Isometry3d lying = moved(-height / 2, 0, radius) * Eigen::AngleAxisd(kPi / 2, Vector3d::UnitY());
  return {"lying can", {{cylinder(radius, height), lying}}, false, {0, 0}};
}

/// With a waist or a belly, a neck and a lid that is wider than the neck.
Thing drawJar(Random& random) {
  const double foot = random.uniform(0.028, 0.042), belly = foot * random.uniform(0.8, 1.3);
  const double shoulder = foot * random.uniform(0.9, 1.2), neck = shoulder * random.uniform(0.5, 0.8);
  const double cap = neck * random.uniform(1, 1.2), height = random.uniform(0.1, 0.26);
  return {"jar",
          {Revolution{{{0, 0},
                       {foot, 0},
                       {belly, 0.35 * height},
                       {shoulder, 0.7 * height},
                       {neck, 0.82 * height},
                       {cap, 0.84 * height},
                       {cap, height},
                       {0, height}}}},
          false,
          {0, 0}};
}

Thing drawPacket(Random& random) {
  const double x = random.uniform(0.04, 0.08), y = random.uniform(0.03, 0.05);
  const Vector3d size(x, y, random.uniform(0.02, 0.05));
  return {"packet", {Box{size}}, true, size.head<2>() / 2};
}

Thing drawFruit(Random& random) { return {"fruit", {sphere(random.uniform(0.021, 0.038))}, false, {0, 0}}; }

/// An arc that lies on its side.
Thing drawBanana(Random& random) {
  const double radius = random.uniform(0.015, 0.019), bend = random.uniform(0.09, 0.14);
  const double half_angle = random.uniform(0.6, 0.8);
  constexpr int kPieces = 8;
  Tube tube{{}, radius};
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = half_angle * (2.0 * i / kPieces - 1);
    tube.path.emplace_back(bend * std::sin(angle), bend * (1 - std::cos(angle)), radius);
  }
  return {"banana", {tube}, false, {0, 0}};
}

/// A carton without its top.
Thing drawOpenBox(Random& random) {
  const double x = random.uniform(0.1, 0.2), y = random.uniform(0.07, 0.14), z = random.uniform(0.05, 0.12);
  const double wall = random.uniform(0.003, 0.006), across = y - 2 * wall;
  return {"open box",
          {{Box{{x - 2 * wall, across, wall}}},
           {Box{{x, wall, z}}, moved(0, (y - wall) / 2, 0)},
           {Box{{x, wall, z}}, moved(0, (wall - y) / 2, 0)},
           {Box{{wall, across, z}}, moved((x - wall) / 2, 0, 0)},
           {Box{{wall, across, z}}, moved((wall - x) / 2, 0, 0)}},
          false,
          {0, 0}};
}

/// On its side: the head across y, the handle along x.
Thing drawHammer(Random& random) {
  const double head = random.uniform(0.08, 0.11), thick = random.uniform(0.02, 0.028);
  const double rod = thick / 2, length = random.uniform(0.16, 0.22);
  return {"hammer",
          {Tube{{{rod, 0, rod}, {length, 0, rod}}, rod}, {Box{{thick, head, thick}}, moved(0, 0, 0)}},
          false,
          {0, 0}};
}

/// Lies on its handle and on the tip of its blade.
Thing drawScrewdriver(Random& random) {
  const double grip = random.uniform(0.012, 0.016), blade = random.uniform(0.003, 0.004);
  const double grip_length = random.uniform(0.07, 0.1), blade_length = random.uniform(0.08, 0.14);
  return {"screwdriver",
          {Tube{{{0, 0, grip}, {grip_length, 0, grip}}, grip}, Tube{{{0, 0, grip}, {-blade_length, 0, blade}}, blade}},
          false,
          {0, 0}};
}

}  // namespace

const std::map<std::string, Maker>& groceryMakers() {
  static const std::map<std::string, Maker> makers{
      {"can", drawCan},          {"lying can", drawLyingCan}, {"jar", drawJar},
      {"packet", drawPacket},    {"fruit", drawFruit},        {"banana", drawBanana},
      {"open box", drawOpenBox}, {"hammer", drawHammer},      {"screwdriver", drawScrewdriver}};
  return makers;
}

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/household.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "sim/groceries.hpp"
#include "sim/profiles.hpp"
#include "sim/tableware.hpp"

namespace objectness::sim {
namespace {

// The widest square in a circle has this share of its diameter.
constexpr double kSquareInCircle = 0.7;

Thing boxThing(const Eigen::Vector3d& size) { return {"box", {Box{size}}, true, size.head<2>() / 2}; }

Thing drawBox(Random& random) {
  const int type = random.integer(0, 2);
  const double x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
  if (type == 0) return boxThing({0.10 + 0.10 * x, 0.04 + 0.05 * y, 0.14 + 0.14 * z});  // carton
  if (type == 1) return boxThing({0.06 + 0.10 * x, 0.05 + 0.07 * y, 0.04 + 0.08 * z});  // packet
  return boxThing({0.16 + 0.10 * x, 0.12 + 0.08 * y, 0.04 + 0.02 * z});                 // thick book
}

Thing drawCylinder(Random& random) {
  const double radius = random.uniform(0.025, 0.06), height = random.uniform(0.06, 0.22);
  return {"cylinder", {cylinder(radius, height)}, true, squareIn(radius)};
}

Thing drawCone(Random& random) {
  const double radius = random.uniform(0.04, 0.08), height = random.uniform(0.08, 0.2);
  const double share = random.chance(0.5) ? random.uniform(0.3, 0.7) : 0;
  return {"cone", {cone(radius, share * radius, height)}, false, {0, 0}};
}

Thing drawSphere(Random& random) { return {"sphere", {sphere(random.uniform(0.03, 0.08))}, false, {0, 0}}; }

Thing drawBowl(Random& random) {
  const double radius = random.uniform(0.07, 0.12), centre_z = radius * random.uniform(0.86, 0.93);
  const double height = centre_z * random.uniform(0.55, 0.85);
  const double thickness = 0.005, inner = radius - thickness, floor_z = centre_z - thickness;
  Thing thing{"bowl", {bowl(radius, height, thickness, centre_z)}, false, {0, 0}};
  thing.hollow = Hollow{thickness, std::sqrt(inner * inner - floor_z * floor_z), centre_z, inner};
  return thing;
}

Thing drawMug(Random& random) {
  const double radius = random.uniform(0.036, 0.046), height = random.uniform(0.08, 0.11), thickness = 0.004;
  const double span = height * random.uniform(0.5, 0.65), rod = random.uniform(0.005, 0.0065);
  return {"mug", {cup(radius, height, thickness), handle(radius, thickness, height / 2, span, rod)}, true, {0, 0}};
}

Thing drawBottle(Random& random) {
  const double radius = random.uniform(0.03, 0.045), height = random.uniform(0.18, 0.3);
  const double neck = random.uniform(0.012, 0.016), shoulder_z = height * random.uniform(0.5, 0.65);
  const double neck_z = shoulder_z + height * random.uniform(0.12, 0.2);
  return {"bottle", {bottle(radius, height, neck, shoulder_z, neck_z)}, true, {0, 0}};
}

}  // namespace

Eigen::AlignedBox3d Thing::box() const {
  Eigen::AlignedBox3d all;
  for (const Part& part : parts) {
    const Eigen::AlignedBox3d box = bounds(part.shape);
    for (int i = 0; i < 8; ++i) {
      all.extend(part.T_thing_part * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    }
  }
  return all;
}

Eigen::Vector2d squareIn(double top_radius) { return Eigen::Vector2d::Constant(kSquareInCircle * top_radius); }

Thing makeThing(const std::string& kind, Random& random) {
  static const std::map<std::string, Maker> makers{
      {"box", drawBox},   {"cylinder", drawCylinder}, {"cone", drawCone},    {"sphere", drawSphere},
      {"bowl", drawBowl}, {"mug", drawMug},           {"bottle", drawBottle}};
  for (const auto* more : {&makers, &tablewareMakers(), &groceryMakers()}) {
    const auto found = more->find(kind);
    if (found != more->end()) return found->second(random);
  }
  throw std::out_of_range("no thing is called " + kind);
}

Thing makeSlab(Random& random) {
  const double width = random.uniform(0.10, 0.2), thickness = random.uniform(0.02, 0.04);
  return boxThing({width, thickness, random.uniform(0.14, 0.26)});
}

cv::Vec3b drawColor(Random& random) {
  const double hue = random.uniform(0, 6), saturation = random.uniform(0.35, 0.9), value = random.uniform(120, 240);
  const auto channel = [&](double peak) {  // 1 at its own hue, falling to 0 two sixths of the circle away
    const double away = std::abs(std::remainder(hue - peak, 6));
    return cv::saturate_cast<uchar>(value * (1 - saturation * (1 - std::clamp(2 - away, 0.0, 1.0))));
  };
  return {channel(4), channel(2), channel(0)};
}

}  // namespace objectness::sim

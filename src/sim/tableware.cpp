// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tableware.hpp"

#include <cmath>

#include "common/angles.hpp"
#include "sim/profiles.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

Thing drawPlate(Random& random) {
  const double radius = random.uniform(0.075, 0.135), height = random.uniform(0.014, 0.032);
  const double floor = radius * random.uniform(0.6, 0.72), thickness = random.uniform(0.004, 0.006);
  Thing thing{"plate", {dish(radius, height, thickness, floor)}, false, {0, 0}};
  thing.hollow = Hollow{thickness, floor, 0, 0};
  return thing;
}

/// A small one: as long as two hands.
Thing drawPan(Random& random) {
  const double radius = random.uniform(0.065, 0.085), height = random.uniform(0.035, 0.06), thickness = 0.003;
  const double floor = radius * random.uniform(0.82, 0.92), rod = random.uniform(0.007, 0.01);
  const double length = random.uniform(0.095, 0.115), rise = random.uniform(0, 0.012);
  const double z = height - rod, start = floor + (radius - floor) * z / height + rod - 0.6 * thickness;
  const Tube handle{{{start, 0, z}, {start + length / 2, 0, z + rise}, {start + length, 0, z + rise}}, rod};
  Thing thing{"pan", {dish(radius, height, thickness, floor), handle}, false, {0, 0}};
  thing.hollow = Hollow{thickness, floor, 0, 0};
  return thing;
}

Thing drawLid(Random& random) {
  const double radius = random.uniform(0.06, 0.11), rim = random.uniform(0.004, 0.01);
  const double height = rim + random.uniform(0.008, 0.025);
  const double knob = random.uniform(0.01, 0.016), knob_height = random.uniform(0.012, 0.022);
  return {"lid", {lid(radius, rim, height, knob, knob_height)}, false, {0, 0}};
}

/// Cutlery lies along x with its handle at +x.
Thing drawKnife(Random& random) {
  const double blade = random.uniform(0.1, 0.13), grip = random.uniform(0.08, 0.1);
  const double width = random.uniform(0.016, 0.022), thickness = random.uniform(0.005, 0.01);
  return {
      "knife",
      {{Box{{grip, width, thickness}}, moved(grip / 2, 0, 0)}, {Box{{blade, width, 0.002}}, moved(-blade / 2, 0, 0)}},
      false,
      {0, 0}};
}

Thing drawFork(Random& random) {
  const double grip = random.uniform(0.11, 0.14), rod = random.uniform(0.003, 0.005), neck = 0.03, tine = 0.0015;
  const double width = random.uniform(0.02, 0.026), tines = random.uniform(0.035, 0.05);
  Thing thing{"fork", {}, false, {0, 0}};
  thing.parts.push_back(Tube{{{0, 0, rod}, {grip / 2, 0, 2 * rod}, {grip, 0, rod}}, rod});
  thing.parts.emplace_back(Box{{neck, width, 0.003}}, moved(-neck / 2, 0, 0));
  for (int i = 0; i < 4; ++i) {
    const double y = (width - 2 * tine) * (i / 3.0 - 0.5);
    thing.parts.push_back(Tube{{{-neck, y, tine}, {-neck - tines, y, tine}}, tine});
  }
  return thing;
}

Thing drawSpoon(Random& random) {
  const double grip = random.uniform(0.11, 0.14), rod = random.uniform(0.003, 0.005);
  const double ball = random.uniform(0.022, 0.028), centre_z = 0.9 * ball, height = 0.45 * ball, thickness = 0.0015;
  const double rim = std::sqrt(ball * ball - (centre_z - height) * (centre_z - height));
  const double z = height - thickness;  // the handle starts at the rim and comes down to the table
  return {"spoon",
          {Tube{{{0, 0, z}, {grip / 3, 0, z + rod}, {grip, 0, rod}}, rod},
           {bowl(ball, height, thickness, centre_z), moved(-rim, 0, 0)}},
          false,
          {0, 0}};
}

Thing rod(const char* kind, double radius, double length) {
  return {kind, {Tube{{{-length / 2, 0, radius}, {length / 2, 0, radius}}, radius}}, false, {0, 0}};
}

Thing drawMarker(Random& random) {
  const double radius = random.uniform(0.008, 0.011);
  return rod("marker", radius, random.uniform(0.1, 0.13));
}

Thing drawPen(Random& random) {
  const double radius = random.uniform(0.0035, 0.006);
  return rod("pen", radius, random.uniform(0.12, 0.14));
}

Thing drawBook(Random& random) {
  const double width = random.uniform(0.12, 0.25), depth = width * random.uniform(0.62, 0.75);
  const Vector3d size(width, depth, random.uniform(0.008, 0.035));
  return {"book", {Box{size}}, true, size.head<2>() / 2};
}

}  // namespace

const std::map<std::string, Maker>& tablewareMakers() {
  static const std::map<std::string, Maker> makers{{"plate", drawPlate},   {"pan", drawPan},   {"lid", drawLid},
                                                   {"knife", drawKnife},   {"fork", drawFork}, {"spoon", drawSpoon},
                                                   {"marker", drawMarker}, {"pen", drawPen},   {"book", drawBook}};
  return makers;
}

}  // namespace objectness::sim

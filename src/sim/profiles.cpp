// SPDX-License-Identifier: BSD-3-Clause
#include "sim/profiles.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"

namespace objectness::sim {
namespace {

constexpr int kHandlePieces = 8;

double leg(double hypotenuse, double other) {
  return std::sqrt(std::max(0.0, hypotenuse * hypotenuse - other * other));
}

}  // namespace

Revolution cylinder(double radius, double height) { return cone(radius, radius, height); }

Revolution cone(double bottom_radius, double top_radius, double height) {
  return {{{0, 0}, {bottom_radius, 0}, {top_radius, height}, {0, height}}};
}

Revolution sphere(double radius) { return {{{0, 0}, {0, 2 * radius, radius}}}; }

Revolution bowl(double radius, double height, double thickness, double centre_z) {
  const double inner = radius - thickness, rim = height - centre_z;
  return {{{0, 0},
           {leg(radius, centre_z), 0},
           {leg(radius, rim), height, centre_z},
           {leg(inner, rim), height},
           {leg(inner, centre_z - thickness), thickness, centre_z},
           {0, thickness}}};
}

Revolution cup(double radius, double height, double thickness) {
  const double inner = radius - thickness;
  return {{{0, 0}, {radius, 0}, {radius, height}, {inner, height}, {inner, thickness}, {0, thickness}}};
}

Revolution dish(double radius, double height, double thickness, double floor_radius) {
  return {{{0, 0},
           {floor_radius, 0},
           {radius, height},
           {radius - thickness, height},
           {floor_radius, thickness},
           {0, thickness}}};
}

Revolution lid(double radius, double rim_height, double height, double knob_radius, double knob_height) {
  // The centre of the sphere is as far from the rim as from the foot of the knob.
  const double centre_z = (knob_radius * knob_radius + height * height - radius * radius - rim_height * rim_height) /
                          (2 * (height - rim_height));
  const double top = height + knob_height;
  return {{{0, 0}, {radius, 0}, {radius, rim_height}, {knob_radius, height, centre_z}, {knob_radius, top}, {0, top}}};
}

Revolution bottle(double radius, double height, double neck_radius, double shoulder_z, double neck_z) {
  return {{{0, 0}, {radius, 0}, {radius, shoulder_z}, {neck_radius, neck_z}, {neck_radius, height}, {0, height}}};
}

Tube handle(double cup_radius, double thickness, double centre_z, double span, double rod_radius) {
  const double start = cup_radius + rod_radius - 0.6 * thickness;
  Tube tube{{}, rod_radius};
  for (int i = 0; i <= kHandlePieces; ++i) {
    const double angle = kPi * (static_cast<double>(i) / kHandlePieces - 0.5);
    tube.path.emplace_back(start + span / 2 * std::cos(angle), 0, centre_z + span / 2 * std::sin(angle));
  }
  return tube;
}

}  // namespace objectness::sim

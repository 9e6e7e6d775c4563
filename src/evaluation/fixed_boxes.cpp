// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/fixed_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/angles.hpp"

namespace objectness::evaluation {
namespace {

/// Width, depth and height in metres of what is common on tables. Few sizes: a hundred boxes of four sizes find more
/// than a hundred of eight, which are sparser each.
const std::array<std::array<double, 3>, 4> kHouseholdSizes_m{{{0.17, 0.12, 0.10},    // packages that lie
                                                              {0.08, 0.08, 0.12},    // cans, mugs
                                                              {0.18, 0.08, 0.22},    // packages that stand
                                                              {0.17, 0.17, 0.08}}};  // bowls

/// Coordinate `axis` of point i of the R3 sequence (Roberts 2018): multiples of powers of 1 / g modulo 1, where g is
/// the root of g^4 = g + 1.
double sequence(int i, int axis) {
  constexpr double g = 1.22074408460575947536;
  double whole;
  return std::modf(0.5 + (i + 1) * std::pow(1 / g, axis + 1), &whole);
}

/// From `low` to `high` but `margin` inside, in the middle where there is no room.
double between(double low, double high, double margin, double share) {
  const double room = std::max(0.0, high - low - 2 * margin);
  return 0.5 * (low + high) + (share - 0.5) * room;
}

}  // namespace

std::vector<OrientedBox> fixedBoxes(const Table& table, const Footprint& footprint, int count) {
  std::vector<OrientedBox> boxes;
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d size(kHouseholdSizes_m[i % kHouseholdSizes_m.size()].data());
    const double angle = kPi * sequence(i, 2), c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
    const double reach_x = 0.5 * (c * size.x() + s * size.y()), reach_y = 0.5 * (s * size.x() + c * size.y());
    Eigen::Isometry3d T_table_box = Eigen::Isometry3d::Identity();
    T_table_box.translation() << between(footprint.low.x(), footprint.high.x(), reach_x, sequence(i, 0)),
        between(footprint.low.y(), footprint.high.y(), reach_y, sequence(i, 1)), 0.5 * size.z();
    T_table_box.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    boxes.push_back({T_camera_table * T_table_box, size});
  }
  return boxes;
}

}  // namespace objectness::evaluation

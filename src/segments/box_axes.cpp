// SPDX-License-Identifier: BSD-3-Clause
#include "segments/box_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace objectness {
namespace {

constexpr double kEqual = 1.03;  // sides whose ratio is less have no longer one
constexpr double kRounding = 1e-6;

}  // namespace

OrientedBox nameAxes(const OrientedBox& box) {
  const Eigen::Matrix3d& axes = box.T_camera_box.linear();
  int z = 2;
  for (const int axis : {0, 1}) {
    if (std::abs(axes(2, axis)) > std::abs(axes(2, z)) + kRounding) z = axis;
  }
  int x = (z + 1) % 3, y = (z + 2) % 3;
  const double shorter = std::min(box.size_m[x], box.size_m[y]), longer = std::max(box.size_m[x], box.size_m[y]);
  const bool swap = longer < kEqual * shorter ? std::abs(axes(0, y)) > std::abs(axes(0, x)) + kRounding
                                              : box.size_m[y] > box.size_m[x];
  if (swap) std::swap(x, y);
  const Eigen::Vector3d up = axes(2, z) < 0 ? Eigen::Vector3d(-axes.col(z)) : Eigen::Vector3d(axes.col(z));
  const bool backwards = std::abs(axes(0, x)) > kRounding ? axes(0, x) < 0 : axes(1, x) < 0;
  const Eigen::Vector3d along = backwards ? Eigen::Vector3d(-axes.col(x)) : Eigen::Vector3d(axes.col(x));
  OrientedBox named = box;
  named.T_camera_box.linear() << along, up.cross(along), up;
  named.size_m = {box.size_m[x], box.size_m[y], box.size_m[z]};
  return named;
}

OrientedBox namedAs(const Eigen::Matrix3d& axes, const OrientedBox& box) {
  OrientedBox nearest = box;
  double best = -4;  // of the trace, which is 1 + 2 cos of the angle between them
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      OrientedBox named = box;
      for (int k = 0; k < 3; ++k) {
        const double sign = signs >> k & 1 ? -1 : 1;
        named.T_camera_box.linear().col(k) = sign * box.T_camera_box.linear().col(order[k]);
        named.size_m[k] = box.size_m[order[k]];
      }
      if (named.T_camera_box.linear().determinant() < 0) continue;
      const double trace = (axes.transpose() * named.T_camera_box.linear()).trace();
      if (trace > best) best = trace, nearest = named;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return nearest;
}

}  // namespace objectness

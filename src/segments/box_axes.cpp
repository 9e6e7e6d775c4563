// SPDX-License-Identifier: BSD-3-Clause
#include "box_axes.hpp"

#include <algorithm>
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

}  // namespace objectness

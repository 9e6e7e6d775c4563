// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/box_overlap.hpp"

#include <algorithm>
#include <vector>

namespace objectness::evaluation {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

/// The part of a polygon where p[axis] * side <= limit.
Polygon clip(const Polygon& polygon, int axis, int side, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double d0 = side * from[axis] - limit, d1 = side * to[axis] - limit;
    if (d0 <= 0) kept.push_back(from);
    if ((d0 <= 0) != (d1 <= 0)) kept.push_back(from + (to - from) * (d0 / (d0 - d1)));
  }
  return kept;
}

double area(const Polygon& polygon) {
  Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    doubled += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return 0.5 * doubled.norm();
}

/// The cones from `apex` to the parts of the faces of one box within the other, volumes signed: behind a face is plus.
/// Everything is in the frame of the outer box, which is given by its half extents.
double conesToFaces(const Eigen::Isometry3d& T_outer_inner, const Eigen::Vector3d& half_inner,
                    const Eigen::Vector3d& half_outer, const Eigen::Vector3d& apex) {
  double volume = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d second = Eigen::Vector3d::Unit((axis + 1) % 3).cwiseProduct(half_inner);
    const Eigen::Vector3d third = Eigen::Vector3d::Unit((axis + 2) % 3).cwiseProduct(half_inner);
    for (const int side : {-1, 1}) {
      const Eigen::Vector3d centre = side * half_inner[axis] * Eigen::Vector3d::Unit(axis);
      Polygon face{centre + second + third, centre - second + third, centre - second - third, centre + second - third};
      for (Eigen::Vector3d& corner : face) corner = T_outer_inner * corner;
      for (int k = 0; k < 3; ++k) face = clip(clip(face, k, 1, half_outer[k]), k, -1, half_outer[k]);
      const Eigen::Vector3d normal = T_outer_inner.linear() * (side * Eigen::Vector3d::Unit(axis));
      volume += area(face) * normal.dot(T_outer_inner * centre - apex) / 3;
    }
  }
  return volume;
}

}  // namespace

double sharedVolume(const OrientedBox& a, const OrientedBox& b) {
  // The surface of the common part consists of the parts of either box's faces within the other. b grows by a
  // nanometre, so that faces that coincide count once.
  constexpr double kGrowth_m = 1e-9;
  const Eigen::Vector3d half_a = 0.5 * a.size_m, half_b = 0.5 * b.size_m + Eigen::Vector3d::Constant(kGrowth_m);
  const Eigen::Isometry3d T_a_b = a.T_camera_box.inverse() * b.T_camera_box, T_b_a = T_a_b.inverse();
  const double volume = conesToFaces(T_b_a, half_a, half_b, T_b_a.translation()) +
                        conesToFaces(T_a_b, half_b, half_a, Eigen::Vector3d::Zero());
  return std::clamp(volume, 0.0, std::min(a.size_m.prod(), b.size_m.prod()));
}

double boxOverlap(const OrientedBox& a, const OrientedBox& b) {
  if (a.size_m.minCoeff() <= 0 || b.size_m.minCoeff() <= 0) return 0;
  const double shared = sharedVolume(a, b);
  return shared / (a.size_m.prod() + b.size_m.prod() - shared);
}

}  // namespace objectness::evaluation

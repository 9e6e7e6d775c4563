// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/normals.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace objectness {

/// The dominant plane P = {n, d} that carries the objects (paper Sec. 2) and its extent.
struct Table {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, optical frame, towards the camera
  double d = 0;                                       ///< n . p + d = 0 on the plane; > 0: the camera's height over it, metres
  /// Maps camera coordinates to the table frame: z along the normal, origin on the plane.
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector2d> hull;  ///< outline of the table's own extent, table frame, metres, counter-clockwise
  DepthNoise noise;                   ///< measured on this frame's table

  double height(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>()) + d; }
};

struct TableConfig {
  bool given = false;
  double given_a = 0, given_b = 0, given_c = 0, given_d = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("given", self.given, "use the plane given_a x + given_b y + given_c z + given_d = 0 instead of searching one");
    visit("given_a", self.given_a, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_b", self.given_b, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_c", self.given_c, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_d", self.given_d, Range{-1e6, 1e6}, "given plane, metres when (a, b, c) is a unit vector");
  }
};

/// Finds the plane that carries the objects, its extent and the sensor's noise on it; kNoTable with the reason otherwise.
Result<Table> findTable(const Frame& frame, const Normals& normals, const TableConfig& config);

}  // namespace objectness

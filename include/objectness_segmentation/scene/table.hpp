// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

/// A raster of the table's own extent in the x-y plane of the table frame: what decides whether a point is "on it".
struct TableExtent {
  static constexpr uchar kCore = 255;    ///< table that was seen, and what it surrounds
  static constexpr uchar kMargin = 128;  ///< next to it: its rounded edge, covered places it probably goes on under
  /// Without depth around, but a thing comes down to the table's height here, and nothing says that the table ends
  /// before it. Whether that is a thing on the table is for the thing to tell.
  static constexpr uchar kBeyond = 64;

  cv::Mat_<uchar> cells;                             ///< row = y, column = x; one of these values, or 0: not the table
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< corner of cell (0, 0) with the smallest x and y, metres
  double cell_m = 0.01;                              ///< side of a cell

  /// The cell that holds a point of the table plane; 0 outside the raster.
  uchar at(double x, double y) const {
    const double column = (x - origin.x()) / cell_m, row = (y - origin.y()) / cell_m;
    const bool within = column >= 0 && row >= 0 && column < cells.cols && row < cells.rows;
    return within ? cells(static_cast<int>(row), static_cast<int>(column)) : uchar(0);
  }
  bool contains(double x, double y) const { return at(x, y) >= kMargin; }
};

/// A plane n . p + d = 0; n is a unit vector in the optical frame, towards the camera (d > 0: the camera's distance).
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double d = 0;

  double height(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>()) + d; }
};

/// The dominant plane P = {n, d} that carries the objects (paper Sec. 2) and its extent.
struct Table : Plane {
  /// Maps camera coordinates to the table frame: z along the normal, x along the camera's x axis laid on the plane,
  /// origin at the foot of the camera.
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
  /// Outline of what is seen of it, table frame, metres, counter-clockwise. Narrower than the extent.
  std::vector<Eigen::Vector2d> hull;
  /// By corner: the side to the next one is the table's edge as it was seen. Otherwise things hide the edge, it lies
  /// beyond the picture or there is no depth, and the side is where the surface was last seen or probably goes on.
  std::vector<char> hull_measured;
  TableExtent extent;               ///< what decides whether a point is on the table
  DepthNoise noise;                 ///< measured on this frame's table
  std::vector<Plane> other_planes;  ///< the frame's other large planes: walls, floor, sides of a bin or of boxes
};

struct TableConfig {
  bool given = false;
  double given_a = 0, given_b = 0, given_c = 0, given_d = 0;
  bool up_known = false;
  double up_x = 0, up_y = -1, up_z = 0;
  double max_tilt_deg = 20;
  double min_area_m2 = 0.02;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("given", self.given,
          "use the plane given_a x + given_b y + given_c z + given_d = 0 instead of searching one");
    visit("given_a", self.given_a, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_b", self.given_b, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_c", self.given_c, Range{-1e6, 1e6}, "given plane, optical frame");
    visit("given_d", self.given_d, Range{-1e6, 1e6}, "given plane, metres when (a, b, c) is a unit vector");
    visit("up_known", self.up_known,
          "only planes whose normal is within max_tilt_deg of (up_x, up_y, up_z) are tables");
    visit("up_x", self.up_x, Range{-1e6, 1e6}, "direction against gravity, optical frame, any length");
    visit("up_y", self.up_y, Range{-1e6, 1e6}, "direction against gravity, optical frame, any length");
    visit("up_z", self.up_z, Range{-1e6, 1e6}, "direction against gravity, optical frame, any length");
    visit("max_tilt_deg", self.max_tilt_deg, Range{0, 90},
          "largest angle between a table's normal and the up direction");
    visit("min_area_m2", self.min_area_m2, Range{0, 10}, "a smaller plane is no table");
  }
};

/// Finds the plane that carries the objects, its extent and the sensor's noise on it.
///
/// Among up to eight planes the one is taken that looks most like a table: things stand on it, it is near and large,
/// and nothing lies under it. Which way is up is not assumed (a wrist camera may hang upside down) unless up_known.
/// kNoTable with what was seen when no plane qualifies; kBadConfig for a given plane or up direction of zero length.
Result<Table> findTable(const Frame& frame, const Normals& normals, const TableConfig& config, int threads = 1);

}  // namespace objectness

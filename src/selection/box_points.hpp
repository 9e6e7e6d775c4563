// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "integral/grid.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "selection/point_bits.hpp"

namespace objectness {

/// The scene points in the order of their bits: neighbours on the table lie together.
std::vector<Eigen::Vector3f> inBitOrder(std::vector<Eigen::Vector3f> points);

/// kappa(p, b) of Eq. 9 for all scene points and the boxes of one angle, one by one in
/// test/reference/point_overlap.hpp: a row of bits for every position of a face. Groups of points that lie wholly
/// beside a box are skipped.
class BoxPoints {
 public:
  /// points: inBitOrder(), table frame, metres; margin_m: boxes count as this much larger on all sides.
  BoxPoints(const std::vector<Eigen::Vector3f>& points, const PointLayout& layout, const Grid& grid, double margin_m);

  /// The points in the box grown by grow_xy voxels on its four sides and grow_z upwards: their number, and the groups
  /// that hold them, the only ones that are written, in `points`.
  int inside(const Box& box, int grow_xy, int grow_z, PointBits& points) const;

 private:
  /// Row i: the points whose coordinate is below i + shift.
  struct Rows {
    int last = 0;
    std::size_t words = 0;
    std::vector<std::uint64_t> bits;
    std::vector<std::uint64_t> before, after;  ///< per row the groups with a point below it, and with one not below it

    void fill(const std::vector<double>& coordinates, int count, double shift, const PointLayout& layout);
    const std::uint64_t* below(int face) const { return &bits[std::clamp(face, 0, last) * words]; }
  };

  PointLayout layout_;
  Rows x_low_, x_high_, y_low_, y_high_, z_high_;
};

}  // namespace objectness

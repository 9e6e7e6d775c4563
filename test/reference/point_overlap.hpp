// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "integral/grid.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "selection/point_set.hpp"

namespace objectness {

/// Answers kappa(p, b) of Eq. 9 for all points at once: which scene points lie in a box of one angle.
///
/// For every position of a face there is a bit row of the points before it; the points of a box are five rows combined.
class PointOverlap {
 public:
  /// points: table frame, metres. margin_m: boxes count as this much larger on all sides, since their faces are sampled
  /// coarser than the voxels they were scored with.
  PointOverlap(const std::vector<Eigen::Vector3f>& points, const Grid& grid, double margin_m);

  /// Points in the box grown by grow_xy voxels on its four sides and grow_z upwards.
  PointSet inside(const Box& box, int grow_xy = 0, int grow_z = 0) const;

 private:
  /// Row i: the points whose coordinate is below i + shift.
  struct Rows {
    std::vector<PointSet> rows;
    void fill(const std::vector<double>& coordinates, int count, double shift);
    const PointSet& below(int face) const;
  };

  Rows x_low_, x_high_, y_low_, y_high_, z_high_;
  std::size_t words_;
};

}  // namespace objectness

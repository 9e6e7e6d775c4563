// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace objectness {

/// The voxel grid over the volume of interest for one box angle (paper Sec. 2 and 2.1). Its axes are the table frame's,
/// turned by the angle about z; voxel (ix, iy, iz) spans [i, i + 1) * voxel_m from the origin. z = 0 is the table.
struct Grid {
  double angle_rad = 0;
  double cosine = 1, sine = 0;  ///< of angle_rad
  double voxel_m = 0.01;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< lower corner in the turned frame
  int nx = 0, ny = 0, nz = 0;

  /// Table frame (metres) to grid coordinates (voxels, real numbers).
  Eigen::Vector3d toGrid(const Eigen::Vector3d& p_table) const {
    return {(cosine * p_table.x() + sine * p_table.y() - origin_m.x()) / voxel_m,
            (-sine * p_table.x() + cosine * p_table.y() - origin_m.y()) / voxel_m, p_table.z() / voxel_m};
  }

  /// Grid coordinates (voxels) to the table frame (metres).
  Eigen::Vector3d toTable(const Eigen::Vector3d& q) const {
    const double x = q.x() * voxel_m + origin_m.x(), y = q.y() * voxel_m + origin_m.y();
    return {cosine * x - sine * y, sine * x + cosine * y, q.z() * voxel_m};
  }

  long voxels() const { return static_cast<long>(nx) * ny * nz; }
};

}  // namespace objectness

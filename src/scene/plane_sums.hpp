// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Sums over weighted points that a least-squares plane follows from; of the products those of the lower triangle.
struct PlaneSums {
  int count = 0;
  double weight = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, yx = 0, zx = 0, yy = 0, zy = 0, zz = 0;

  void add(double px, double py, double pz, double w) {
    const double wx = w * px, wy = w * py, wz = w * pz;
    ++count;
    weight += w;
    x += wx, y += wy, z += wz;
    xx += wx * px, yx += wy * px, zx += wz * px;
    yy += wy * py, zy += wz * py, zz += wz * pz;
  }
};

}  // namespace objectness

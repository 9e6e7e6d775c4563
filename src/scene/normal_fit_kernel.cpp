// SPDX-License-Identifier: BSD-3-Clause
#include "scene/normal_fit_kernel.hpp"

#include <cmath>

#include "common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("avx2")
void fitPlanesInRow(const FitCamera& camera, int row, const WindowRow& windows, int count, const FittedRow& fitted) {
  const FitCamera k = camera;
  const double above_centre = k.cy - row;
  const int* column = windows.column;
  const double *pixels = windows.pixels, *second_moment = windows.second_moment;
  const double *w = windows.w, *uw = windows.uw, *vw = windows.vw, *ww = windows.ww;
  float *normal_x = fitted.normal_x, *normal_y = fitted.normal_y, *normal_z = fitted.normal_z;
  float *residual_m = fitted.residual_m, *depth_m = fitted.depth_m;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double a = uw[i] / second_moment[i], b = vw[i] / second_moment[i], c = w[i] / pixels[i];
    // u = fx x/z + cx turns the fit into (a fx) x + (b fy) y + (a (cx - u0) + b (cy - v0) + c) z = 1: away from the
    // camera.
    const double x = a * k.fx, y = b * k.fy, z = a * (k.cx - column[i]) + b * above_centre + c;
    const double norm = std::sqrt(x * x + y * y + z * z);
    const double spread = (ww[i] - c * w[i] - a * uw[i] - b * vw[i]) / pixels[i];
    const double depth = kInverseDepthScale / c;
    const double depth_residual = std::sqrt(spread > 0 ? spread : 0) / kInverseDepthScale * depth * depth;
    normal_x[i] = static_cast<float>(-x / norm);
    normal_y[i] = static_cast<float>(-y / norm);
    normal_z[i] = static_cast<float>(-z / norm);
    residual_m[i] = static_cast<float>(depth_residual * c / norm);
    depth_m[i] = static_cast<float>(depth);
  }
}

}  // namespace objectness

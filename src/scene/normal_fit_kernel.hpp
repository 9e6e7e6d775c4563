// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Inverse depths are in fixed point, so that their sums are exact: a step of 2^-20 / m is 1 um at 1 m, 36 um at 6 m.
constexpr double kInverseDepthScale = 1048576.0;

/// Square windows of one row of pixels, an entry each: sums over the window of the inverse depth w, of w times the
/// column and row counted from the middle, and of w^2.
struct WindowRow {
  const int* column;
  const double *pixels, *second_moment;  ///< of the window: their number, and the sum of (u - u0)^2
  const double *w, *uw, *vw, *ww;
};

/// The fitted planes: unit normal towards the camera, RMS distance of the window's points, depth in its middle.
struct FittedRow {
  float *normal_x, *normal_y, *normal_z, *residual_m, *depth_m;
};

struct FitCamera {
  double fx, fy, cx, cy;
};

/// 1/z = a (u - u0) + b (v - v0) + c over each window of row v0. 1/z is in units of 1 / kInverseDepthScale.
void fitPlanesInRow(const FitCamera& camera, int row, const WindowRow& windows, int count, const FittedRow& fitted);

}  // namespace objectness

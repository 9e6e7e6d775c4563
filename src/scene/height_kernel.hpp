// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// A table, its extent's raster, and the height over it that noise does not explain.
struct HeightRule {
  float normal[3], d;
  float x_axis[3], y_axis[3];
  float x_origin, y_origin, inverse_cell;  ///< of the raster
  int columns, rows;
  float sigmas, constant, quadratic;  ///< depth noise: sigmas (constant + quadratic z^2), seen along the normal
  float low, high;                    ///< limits of the threshold
};

/// For a row of points (x, y, z one after the other; NaN: invalid) height and threshold, and the index of the raster's
/// cell a point's foot lies in, -1 outside.
void measureHeights(const float* points, int width, const HeightRule& rule, float* height_m, float* threshold_m,
                    int* cell);

}  // namespace objectness

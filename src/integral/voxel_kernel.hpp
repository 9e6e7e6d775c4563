// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace objectness {

// Loops over many points or voxels. Plain types only: compiled for several instruction sets. Each does the arithmetic
// of the function it stands in for in the same order, so that the results are the same to the last bit.

/// Grid, as its toGrid() needs it.
struct TurnedGrid {
  double cosine, sine, origin_x, origin_y, voxel_m;
  int nx, ny;
};

/// The columns that points (table frame, metres) fall into (Grid::toGrid()); -1 where the grid ends before.
void columnsOf(const float* x, const float* y, int count, const TurnedGrid& grid, std::int32_t* column_x,
               std::int32_t* column_y);

/// Least and largest c x + s y and -s x + c y of the points, in bounds[0..3] = x low, x high, y low, y high.
void turnedBounds(const float* x, const float* y, int count, float c, float s, float bounds[4]);

/// Least and largest entry >= 0; low > high when there is none.
void indexRange(const std::int32_t* index, int count, int& low, int& high);

/// A depth image, transposed (v runs fastest), in which missing pixels are infinitely far or near.
struct TransposedDepth {
  const float* depth;
  int width, height;
  double fx, fy, cx, cy;
  double tolerance_m;
};

/// isOccluded() of the eight points lowest + (first + i) * step (camera frame, metres); bit i for each.
unsigned occludedOfEight(const TransposedDepth& view, const double lowest[3], const double step[3], int first);

}  // namespace objectness

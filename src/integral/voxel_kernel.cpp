// SPDX-License-Identifier: BSD-3-Clause
#include "integral/voxel_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("avx2")
void columnsOf(const float* x, const float* y, int count, const TurnedGrid& grid, std::int32_t* column_x,
               std::int32_t* column_y) {
  const double c = grid.cosine, s = grid.sine, ox = grid.origin_x, oy = grid.origin_y, voxel = grid.voxel_m;
  const double nx = grid.nx, ny = grid.ny;
  for (int i = 0; i < count; ++i) {
    const double px = x[i], py = y[i];
    const double qx = (c * px + s * py - ox) / voxel, qy = (-s * px + c * py - oy) / voxel;
    // Not negative, so that cutting off is rounding down; false for NaN.
    column_x[i] = qx >= 0 && qx < nx ? static_cast<std::int32_t>(qx) : -1;
    column_y[i] = qy >= 0 && qy < ny ? static_cast<std::int32_t>(qy) : -1;
  }
}

OBJECTNESS_CLONES("avx2")
void turnedBounds(const float* x, const float* y, int count, float c, float s, float bounds[4]) {
  // A lane each, so that the compiler may compare eight points at once: the order makes no difference.
  constexpr int kLanes = 8;
  constexpr float kFar = 3.402823466e38f;
  float x_low[kLanes], x_high[kLanes], y_low[kLanes], y_high[kLanes];
  for (int k = 0; k < kLanes; ++k) x_low[k] = y_low[k] = kFar, x_high[k] = y_high[k] = -kFar;
  for (int first = 0; first < count; first += kLanes) {
    float px[kLanes], py[kLanes];
    for (int k = 0; k < kLanes; ++k) {
      const int i = first + k < count ? first + k : count - 1;
      px[k] = x[i], py[k] = y[i];
    }
    for (int k = 0; k < kLanes; ++k) {
      const float qx = c * px[k] + s * py[k], qy = -s * px[k] + c * py[k];
      x_low[k] = qx < x_low[k] ? qx : x_low[k];
      x_high[k] = qx > x_high[k] ? qx : x_high[k];
      y_low[k] = qy < y_low[k] ? qy : y_low[k];
      y_high[k] = qy > y_high[k] ? qy : y_high[k];
    }
  }
  bounds[0] = x_low[0], bounds[1] = x_high[0], bounds[2] = y_low[0], bounds[3] = y_high[0];
  for (int k = 1; k < kLanes; ++k) {
    bounds[0] = x_low[k] < bounds[0] ? x_low[k] : bounds[0];
    bounds[1] = x_high[k] > bounds[1] ? x_high[k] : bounds[1];
    bounds[2] = y_low[k] < bounds[2] ? y_low[k] : bounds[2];
    bounds[3] = y_high[k] > bounds[3] ? y_high[k] : bounds[3];
  }
}

OBJECTNESS_CLONES("avx2")
void indexRange(const std::int32_t* index, int count, int& low, int& high) {
  std::uint32_t least = 0xFFFFFFFFu;  // what is negative wraps around to more than any index
  std::int32_t largest = -1;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t value = static_cast<std::uint32_t>(index[i]);
    least = value < least ? value : least;
    largest = index[i] > largest ? index[i] : largest;
  }
  low = least > 0x7FFFFFFFu ? 0 : static_cast<int>(least);
  high = largest;
}

OBJECTNESS_CLONES("avx2")
unsigned occludedOfEight(const TransposedDepth& view, const double lowest[3], const double step[3], int first) {
  constexpr int kLanes = 8;
  double u[kLanes], v[kLanes], depth[kLanes];
  std::int32_t pixel[kLanes];
  const double width = view.width, height = view.height;
  for (int i = 0; i < kLanes; ++i) {
    const double k = first + i;
    const double px = lowest[0] + k * step[0], py = lowest[1] + k * step[1], pz = lowest[2] + k * step[2];
    u[i] = view.fx * px / pz + view.cx + 0.5;
    v[i] = view.fy * py / pz + view.cy + 0.5;
    depth[i] = pz;
  }
  for (int i = 0; i < kLanes; ++i) {
    const bool inside = depth[i] > 0 && u[i] >= 0 && v[i] >= 0 && u[i] < width && v[i] < height;
    pixel[i] = inside ? static_cast<std::int32_t>(u[i]) * view.height + static_cast<std::int32_t>(v[i]) : -1;
  }
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) {
    if (pixel[i] >= 0 && depth[i] > view.depth[pixel[i]] + view.tolerance_m) bits |= 1u << i;
  }
  return bits;
}

}  // namespace objectness

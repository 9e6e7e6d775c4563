// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/pixel_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

/// Of a pixel's coordinate in the image, which is over -0.5: std::lround() in place.
inline int nearest(float x) {
  const int whole = static_cast<int>(x);
  return whole + (x - static_cast<float>(whole) >= 0.5f ? 1 : 0);
}

}  // namespace

OBJECTNESS_CLONES("avx2")
void findPixels(const PixelCamera& camera, const float* x, const float* y, const float* z, int count, int* pixels) {
  const PixelCamera k = camera;
  const float right = static_cast<float>(k.width) - 0.5f, bottom = static_cast<float>(k.height) - 0.5f;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const float u = k.fx * x[i] / z[i] + k.cx, v = k.fy * y[i] / z[i] + k.cy;
    const bool in_view = (z[i] > 0) & (u > -0.5f) & (v > -0.5f) & (u < right) & (v < bottom);
    const int pixel = nearest(in_view ? v : 0.f) * k.width + nearest(in_view ? u : 0.f);
    pixels[i] = in_view ? pixel : -1;
  }
}

}  // namespace objectness

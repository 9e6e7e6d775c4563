// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "grouping/pixel_kernel.hpp"

using namespace objectness;

TEST(PixelKernel, FindsThePixelsThatPointsAreSeenAt) {
  const PixelCamera camera{525.f, 520.f, 319.5f, 239.5f, 640, 480};
  constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
  // Corners of the picture and what is hardly in it, behind the camera, in it, and no point at all.
  std::vector<float> x{-319.5f, 320.0f, 320.1f, -320.0f, -319.9f, 0, 0, 0, kNan, kInfinity, 0, 0};
  std::vector<float> y{-239.5f, 240.0f, 0, 0, 0, 0, 0, 0, 0, 0, kInfinity, 0};
  std::vector<float> z{525, 525, 525, 525, 525, -525, 0, -0.f, 525, 525, 525, kNan};
  std::mt19937 random(2);
  for (int i = 0; i < 5001; ++i) {
    const auto between = [&](float low, float high) { return low + (high - low) * (random() % 10000) / 10000.f; };
    x.push_back(between(-1, 1)), y.push_back(between(-1, 1)), z.push_back(between(-0.3f, 2));
  }
  std::vector<int> pixels(x.size(), -7);
  findPixels(camera, x.data(), y.data(), z.data(), static_cast<int>(x.size()), pixels.data());
  int in_view = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const float u = camera.fx * x[i] / z[i] + camera.cx, v = camera.fy * y[i] / z[i] + camera.cy;
    const bool seen = z[i] > 0 && u > -0.5f && v > -0.5f && u < 639.5f && v < 479.5f;
    const int expected = seen ? static_cast<int>(std::lround(v) * 640 + std::lround(u)) : -1;
    EXPECT_EQ(pixels[i], expected) << x[i] << " " << y[i] << " " << z[i];
    in_view += seen;
  }
  EXPECT_EQ(pixels[0], 2 * 640);  // u = 0, v = 2.3
  EXPECT_GT(in_view, 1000);
  EXPECT_LT(in_view, 4500);
}

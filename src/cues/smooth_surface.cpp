// SPDX-License-Identifier: BSD-3-Clause
#include "cues/smooth_surface.hpp"

#include <algorithm>
#include <cmath>

#include "common/row_bands.hpp"
#include "cues/crease.hpp"

namespace objectness {
namespace {

constexpr double kMinGap = 0.004;  // metres
constexpr double kGapSigmas = 4.0;

}  // namespace

SmoothSurface connectSmooth(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                            const cv::Mat_<uchar>& smooth, const SuperpixelsConfig& config, int threads) {
  const int width = smooth.cols;
  const float min_cosine = static_cast<float>(std::cos(config.neighbor_deg * M_PI / 180));
  const double focal = frame.camera.focal();
  const auto connected = [&](int a, int b) {
    if (!smooth.data[b] || !(normals.normal[a].dot(normals.normal[b]) > min_cosine)) return false;
    const double z_a = frame.points[a].z(), z_b = frame.points[b].z(), z = std::min(z_a, z_b);
    const double step = std::abs(z_a - z_b);
    return step < kMinGap || step < std::max(kGrazingSlope * z / focal, kGapSigmas * noise.sigma(z));
  };
  SmoothSurface surface{smooth, cv::Mat_<uchar>(smooth.size())};
  forRowBands(smooth.rows, threads, [&](int first, int last) {
    for (int v = first; v < last; ++v) {
      const bool has_below = v + 1 < smooth.rows;
      for (int u = 0, i = v * width; u < width; ++u, ++i) {
        uchar ways = 0;
        if (smooth.data[i]) {
          if (u + 1 < width && connected(i, i + 1)) ways |= SmoothSurface::kRight;
          if (has_below && u > 0 && connected(i, i + width - 1)) ways |= SmoothSurface::kLowerLeft;
          if (has_below && connected(i, i + width)) ways |= SmoothSurface::kDown;
          if (has_below && u + 1 < width && connected(i, i + width + 1)) ways |= SmoothSurface::kLowerRight;
        }
        surface.ways.data[i] = ways;
      }
    }
  });
  return surface;
}

}  // namespace objectness

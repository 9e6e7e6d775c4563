// SPDX-License-Identifier: BSD-3-Clause
#include "scene/depth_discontinuities.hpp"

#include <algorithm>

#include "common/row_bands.hpp"
#include "scene/depth_discontinuity_kernel.hpp"

namespace objectness {
namespace {

void copyDepths(const Frame& frame, int v, float* z) {
  const Eigen::Vector3f* points = frame.points.data() + std::size_t(v) * frame.width();
  for (int u = 0; u < frame.width(); ++u) z[u] = points[u].z();
}

/// An image with a margin of 255 to either side of its rows, for spreadDistance().
class DistanceRows {
 public:
  DistanceRows(int width, int height)
      : stride_(width + 2 * kDistanceMargin),
        bytes_(std::size_t(stride_) * (height + 1), uchar(255)),
        height_(height) {}
  uchar* row(int v) { return bytes_.data() + std::size_t(v) * stride_ + kDistanceMargin; }
  uchar* scratch() { return row(height_); }

 private:
  int stride_;
  std::vector<uchar> bytes_;
  int height_;
};

}  // namespace

std::vector<unsigned char> findDepthDiscontinuities(const Frame& frame, const NormalsConfig& config,
                                                    const DepthNoise& noise, int threads) {
  const int width = frame.width(), height = frame.height();
  const DiscontinuityLimits limits{static_cast<float>(config.jump_sigmas * noise.constant_m),
                                   static_cast<float>(config.jump_sigmas * noise.quadratic_per_m),
                                   static_cast<float>(config.jump_slope / frame.camera.focal())};
  std::vector<unsigned char> jump(static_cast<std::size_t>(frame.size()));
  forRowBands(height, threads, [&](int first, int last) {
    std::vector<float> z(width), below(width);
    copyDepths(frame, first, z.data());
    for (int v = first; v < last; ++v) {
      const bool has_below = v + 1 < height;
      if (has_below) copyDepths(frame, v + 1, below.data());
      findDiscontinuitiesInRow(z.data(), has_below ? below.data() : nullptr, width, limits,
                               jump.data() + std::size_t(v) * width);
      std::swap(z, below);
    }
  });
  return jump;
}

cv::Mat_<uchar> clearRadius(const Frame& frame, const std::vector<unsigned char>& jump, int threads, int most) {
  const int width = frame.width(), height = frame.height();
  std::vector<uchar> valid(static_cast<std::size_t>(frame.size()));
  forRowBands(height, threads, [&](int first, int last) {
    for (int i = first * width; i < last * width; ++i) valid[i] = frame.points[i].z() > 0 ? 255 : 0;
  });

  // 0 = a window may not reach beyond this pixel: it lies beside a jump, beside (8-neighbours) a hole, or at the border
  // (so there always is a 0 to measure the distance from).
  const std::vector<uchar> outside(width, 0);
  const auto rowOf = [&](int v) -> ClearRow {
    if (v < 0 || v >= height) return {outside.data(), outside.data()};
    return {valid.data() + std::size_t(v) * width, jump.data() + std::size_t(v) * width};
  };
  cv::Mat_<uchar> radius(height, width);
  const int bands = ThreadPool::resolve(threads), rows_per_band = (height + bands - 1) / bands;
  forRowBands(
      height, threads,
      [&](int first, int last) {
        // What is farther than `most` from a band does not matter to it.
        const int top = std::max(0, first - most), bottom = std::min(height, last + most);
        DistanceRows distance(width, bottom - top);
        const auto row = [&](int v) { return distance.row(v - top); };
        for (int v = top; v < bottom; ++v) findClearInRow(rowOf(v - 1), rowOf(v), rowOf(v + 1), width, row(v));
        for (int v = top; v < bottom; ++v) {
          spreadDistance(v > top ? row(v - 1) : nullptr, width, most, row(v), distance.scratch());
        }
        for (int v = bottom - 2; v >= first; --v) spreadDistance(row(v + 1), width, most, row(v), distance.scratch());
        for (int v = first; v < last; ++v) {
          std::transform(row(v), row(v) + width, radius[v],
                         [&](uchar clear) { return std::min(clear, static_cast<uchar>(most)); });
        }
      },
      rows_per_band);
  return radius;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/depth_difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace objectness {
namespace {

constexpr double kMostDisparity_px = 0.2, kLeastBaseline_m = 0.05;  // more noise than that is none

constexpr double kOneSigma = 0.683;  // share of a normal distribution within it
constexpr float kBin = 0.0001f;
constexpr int kBins = 400;
constexpr double kMinMoved = 0.3;            // of the picture, in blocks that deviate
constexpr double kMovedTogether = 0.6;       // share of the deviations that whole blocks have in common
constexpr int kPart_px = 64, kEvery_px = 4;  // parts of the picture that are measured, and pixels of them
constexpr int kMinInPart = 16;

/// Standard deviation of one frame from the mean of so many others, in those of one frame.
const std::array<float, kMostFused + 1> kOfMean = [] {
  std::array<float, kMostFused + 1> table{};
  for (int count = 1; count <= kMostFused; ++count) table[count] = std::sqrt(1 + 1 / static_cast<float>(count));
  return table;
}();

/// Deviations as sizes, counted.
class DeviationCounts {
 public:
  void add(float size) { ++bins_[std::min(kBins - 1, static_cast<int>(size / kBin))]; }
  /// The size that `share` are not above; kBins * kBin or more counts as that.
  float quantile(double share) const {
    std::int64_t all = 0, below = 0;
    for (const std::int64_t count : bins_) all += count;
    for (int i = 0; i < kBins; ++i) {
      below += bins_[i];
      if (below > 0 && static_cast<double>(below) >= share * static_cast<double>(all))
        return kBin * static_cast<float>(i + 1);
    }
    return 0;
  }

 private:
  std::array<std::int64_t, kBins> bins_{};
};

}  // namespace

float mostNoise(const PinholeCamera& camera) {
  return static_cast<float>(kMostDisparity_px / (camera.focal() * kLeastBaseline_m));
}

float sigmasOfMean(int count) { return kOfMean[count]; }

DepthDifference compareDepth(const Frame& frame, const cv::Mat_<float>& known, const cv::Mat_<uchar>& count) {
  DepthDifference difference;
  const float limit = kJumpSigmas * mostNoise(frame.camera);
  DeviationCounts counts;
  double together = 0, deviating = 0;
  int measured = 0;
  for (int top = 0; top < known.rows; top += kPart_px) {
    for (int left = 0; left < known.cols; left += kPart_px) {
      double sum = 0, sizes = 0;
      int pixels = 0;
      for (int v = top; v < std::min(known.rows, top + kPart_px); v += kEvery_px) {
        for (int u = left; u < std::min(known.cols, left + kPart_px); u += kEvery_px) {
          const float now = inverseOf(frame.points[v * known.cols + u]), before = known(v, u);
          if (now == 0 || before == 0) continue;
          const float d = std::clamp(now - before, -limit, limit);
          counts.add(std::abs(now - before) / sigmasOfMean(count(v, u)));
          sum += d;
          sizes += std::abs(d);
          ++pixels;
        }
      }
      measured += pixels;
      if (pixels < kMinInPart || sizes < 0.5 * kLeastNoise * pixels) continue;
      together += pixels * std::abs(sum) / sizes;
      deviating += pixels;
    }
  }
  difference.sigma = counts.quantile(kOneSigma);
  difference.moved_together = together > kMovedTogether * deviating && deviating > kMinMoved * measured;
  return difference;
}

}  // namespace objectness

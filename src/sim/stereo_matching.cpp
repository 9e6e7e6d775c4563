// SPDX-License-Identifier: BSD-3-Clause
#include "sim/stereo_matching.hpp"

#include <algorithm>
#include <cmath>

#include "common/parallel.hpp"

namespace objectness::sim {
namespace {

constexpr int kMatchingRadius_px = 4;  // windows of 9 x 9, a common size
constexpr double kBlended_px = 1.0;    // disparities nearer to each other than this blend, others win or lose

}  // namespace

cv::Mat_<double> matchedDepths(const SurfaceView& view, const DepthSensor& sensor, int threads) {
  const PinholeCamera& camera = view.camera;
  const double focal_baseline = camera.fx * sensor.baseline_m;
  cv::Mat_<double> disparity(camera.height, camera.width, 0.0), depth(camera.height, camera.width, 0.0);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      if (view.at(v, u).body && view.at(v, u).depth_m > 0) disparity(v, u) = focal_baseline / view.at(v, u).depth_m;
    }
  }
  parallelFor(camera.height, threads, [&](int v) {
    for (int u = 0; u < camera.width; ++u) {
      const double own = disparity(v, u);
      if (own == 0) continue;
      double sum = 0;
      int count = 0;
      for (int y = std::max(0, v - kMatchingRadius_px); y <= std::min(camera.height - 1, v + kMatchingRadius_px); ++y) {
        for (int x = std::max(0, u - kMatchingRadius_px); x <= std::min(camera.width - 1, u + kMatchingRadius_px);
             ++x) {
          const double other = disparity(y, x);
          if (other == 0 || std::abs(other - own) >= kBlended_px) continue;
          sum += other;
          ++count;
        }
      }
      depth(v, u) = focal_baseline * count / sum;
    }
  });
  return depth;
}

}  // namespace objectness::sim

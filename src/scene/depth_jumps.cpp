// SPDX-License-Identifier: BSD-3-Clause
#include "depth_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace objectness {

std::vector<unsigned char> findDepthJumps(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise) {
  const int width = frame.width(), height = frame.height();
  const float slope = static_cast<float>(config.jump_slope / frame.camera.focal());
  const float sigma_constant = static_cast<float>(config.jump_sigmas * noise.constant_m);
  const float sigma_quadratic = static_cast<float>(config.jump_sigmas * noise.quadratic_per_m);
  const auto apart = [&](float a, float b) {
    const float z = std::min(a, b);
    // Negated, so that a NaN on either side counts as a jump.
    return !(std::abs(a - b) <= std::max(sigma_constant + sigma_quadratic * z * z, slope * z));
  };
  std::vector<unsigned char> jump(static_cast<std::size_t>(frame.size()), 0);
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      const float z = frame.points[i].z();
      if (u + 1 < width && apart(z, frame.points[i + 1].z())) jump[i] |= kJumpRight;
      if (v + 1 < height && apart(z, frame.points[i + width].z())) jump[i] |= kJumpDown;
    }
  }
  return jump;
}

cv::Mat_<uchar> clearRadius(const Frame& frame, const std::vector<unsigned char>& jump) {
  const int width = frame.width(), height = frame.height();
  // 0 = a window may not reach beyond this pixel: it lies beside a jump, beside (8-neighbours) a hole, or at the border
  // (so there always is a 0 to measure the distance from).
  cv::Mat_<uchar> valid(height, width);
  for (int i = 0; i < frame.size(); ++i) valid(i / width, i % width) = frame.points[i].z() > 0 ? 255 : 0;
  cv::Mat_<uchar> clear;
  cv::erode(valid, clear, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      if (jump[i] & kJumpRight) clear(v, u) = clear(v, u + 1) = 0;
      if (jump[i] & kJumpDown) clear(v, u) = clear(v + 1, u) = 0;
      if (u + 1 == width || v + 1 == height) continue;
      // Diagonal neighbours are apart when both ways around the block are cut.
      const bool top = jump[i] & kJumpRight, bottom = jump[i + width] & kJumpRight;
      const bool left = jump[i] & kJumpDown, right = jump[i + 1] & kJumpDown;
      if ((top || right) && (left || bottom)) clear(v, u) = clear(v + 1, u + 1) = 0;
      if ((top || left) && (right || bottom)) clear(v, u + 1) = clear(v + 1, u) = 0;
    }
  }
  cv::Mat distance;
  cv::distanceTransform(clear, distance, cv::DIST_C, 3, CV_32F);
  cv::Mat_<uchar> radius;
  distance.convertTo(radius, CV_8U);
  return radius;
}

}  // namespace objectness

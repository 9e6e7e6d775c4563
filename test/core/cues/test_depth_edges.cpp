// SPDX-License-Identifier: BSD-3-Clause
// Depth edges found where the kernel says that there may be any, beside looking at every pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "cues/crease.hpp"
#include "cues/depth_edges.hpp"
#include "fixtures/random_frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

class PlainDepthEdges {
 public:
  PlainDepthEdges(const Frame& frame, const Normals& normals, const DepthNoise& noise, const EdgesConfig& config)
      : frame_(frame), normals_(normals), noise_(noise), config_(config) {}

  cv::Mat_<uchar> run() {
    const int width = frame_.width(), height = frame_.height();
    kinds_ = cv::Mat_<uchar>(height, width, uchar(0));
    continues_ = cv::Mat_<uchar>(height, width, uchar(0));
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        if (!valid(u, v)) continue;
        const int left = stepsToValid(u, v, -1, 0), up = stepsToValid(u, v, 0, -1);
        if (left > 0) compare(v * width + u - left, v * width + u, left);
        if (up > 0) compare((v - up) * width + u, v * width + u, up);
      }
    }
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool beside = !valid(u - 1, v) || !valid(u + 1, v) || !valid(u, v - 1) || !valid(u, v + 1);
        if (valid(u, v) && beside && kinds_(v, u) == 0 && !continues_(v, u)) kinds_(v, u) = kBorder;
      }
    }
    return kinds_;
  }

 private:
  bool valid(int u, int v) const {
    return u >= 0 && v >= 0 && u < frame_.width() && v < frame_.height() &&
           !std::isnan(frame_.points[v * frame_.width() + u].z());
  }

  /// To the next valid pixel in a direction; 0: none.
  int stepsToValid(int u, int v, int du, int dv) const {
    for (int steps = 1; u + steps * du >= 0 && v + steps * dv >= 0; ++steps) {
      if (valid(u + steps * du, v + steps * dv)) return steps;
    }
    return 0;
  }

  Eigen::Vector3f normalAtRim(int pixel, int du, int dv) const {
    for (int k = 0; k < kMinWindowPx; ++k) {
      const int u = pixel % frame_.width() + k * du, v = pixel / frame_.width() + k * dv;
      if (u < 0 || v < 0 || u >= frame_.width() || v >= frame_.height()) break;
      // The image's last pixel along the way is not looked at.
      const int next_u = u + du, next_v = v + dv;
      if (next_u < 0 || next_v < 0 || next_u >= frame_.width() || next_v >= frame_.height()) break;
      if (normals_.radius_px[v * frame_.width() + u] > 0) return normals_.normal[v * frame_.width() + u];
    }
    return normals_.normal[pixel];
  }

  void compare(int a, int b, int steps) {
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z();
    const double near = std::min(z_a, z_b), difference = std::abs(z_a - z_b);
    const double step = std::max(
        {config_.step_m, config_.step_sigmas * noise_.sigma(near), kGrazingSlope * near / frame_.camera.focal()});
    if (steps > 1 && steps * near > config_.gap_m * frame_.camera.focal()) return;
    bool apart = difference > step;
    if (apart && steps > 1) {
      const bool row = a / frame_.width() == b / frame_.width();
      const int du = row ? 1 : 0, dv = row ? 0 : 1;
      const Eigen::Vector3f gap = frame_.points[b] - frame_.points[a];
      apart = !(std::abs(normalAtRim(a, -du, -dv).dot(gap)) < step && std::abs(normalAtRim(b, du, dv).dot(gap)) < step);
    }
    if (apart) {
      kinds_(z_a < z_b ? a : b) |= kOccluding;
      kinds_(z_a < z_b ? b : a) |= kOccluded;
    }
    if (steps > 1) continues_(a) = continues_(b) = 1;
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const EdgesConfig& config_;
  cv::Mat_<uchar> kinds_, continues_;
};

}  // namespace

TEST(DepthEdges, AreThoseOfLookingAtEveryPixel) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    Frame frame = randomFrame(150, 110, seed);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int v = 30; v < 45; ++v) {  // holes, wider and narrower than the gap
      for (int u = 20; u < 20 + v - 20; ++u) frame.points[v * 150 + u].setConstant(nan);
    }
    for (int v = 0; v < 110; ++v) frame.points[v * 150 + 100 + v % 3].setConstant(nan);
    const Normals normals = estimateNormals(frame, {});
    for (const double step_m : {0.002, 0.01, 0.05}) {
      EdgesConfig config;
      config.step_m = step_m;
      const cv::Mat_<uchar> plain = PlainDepthEdges(frame, normals, {}, config).run();
      EXPECT_GT(cv::countNonZero(plain & kOccluding), 20);
      EXPECT_GT(cv::countNonZero(plain & kBorder), 20);
      for (const int threads : {1, 2}) {
        const cv::Mat_<uchar> kinds = findDepthEdges(frame, normals, {}, config, threads);
        EXPECT_EQ(cv::norm(kinds, plain, cv::NORM_INF), 0) << seed << " " << step_m;
      }
    }
  }
}

TEST(DepthEdges, AreTheSameFromAnyPixelOn) {
  Frame frame = randomFrame(150, 110, 7);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int v = 50; v < 80; ++v) {
    for (int u = 40; u < 52; ++u) frame.points[v * 150 + u].setConstant(nan);
  }
  const Normals normals = estimateNormals(frame, {});
  const cv::Mat_<uchar> whole = findDepthEdges(frame, normals, {}, {});
  for (const cv::Point first :
       {cv::Point(0, 0), cv::Point(1, 1), cv::Point(45, 30), cv::Point(46, 60), cv::Point(149, 109)}) {
    for (const int threads : {1, 2}) {
      const cv::Mat_<uchar> part = findDepthEdges(frame, normals, {}, {}, threads, first);
      const cv::Rect rest(first, cv::Point(150, 110));
      EXPECT_EQ(cv::norm(part(rest), whole(rest), cv::NORM_INF), 0) << first;
    }
  }
}

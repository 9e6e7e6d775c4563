// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "objectness_segmentation/tracking/depth_fusion.hpp"

using namespace objectness;

namespace {

constexpr int kWidth = 160, kHeight = 120;

/// Inverse depth by pixel; 0: a hole.
Frame frameOf(const cv::Mat_<float>& inverse_m) {
  Frame frame;
  frame.camera = {150, 150, 79.5, 59.5, inverse_m.cols, inverse_m.rows};
  for (int v = 0; v < inverse_m.rows; ++v) {
    for (int u = 0; u < inverse_m.cols; ++u) {
      const Eigen::Vector3d ray = frame.camera.ray(u, v);
      frame.points.push_back(inverse_m(v, u) > 0 ? Eigen::Vector3f((ray / inverse_m(v, u)).cast<float>())
                                                 : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
  }
  return frame;
}

/// A table that is seen from the front, 1 m away in the middle.
cv::Mat_<float> table() {
  cv::Mat_<float> inverse_m(kHeight, kWidth);
  for (int v = 0; v < kHeight; ++v) inverse_m.row(v) = 0.8f + 0.4f * v / kHeight;
  return inverse_m;
}

cv::Mat_<float> noisy(const cv::Mat_<float>& inverse_m, unsigned seed, float sigma = 0.002f) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, sigma);
  cv::Mat_<float> out = inverse_m.clone();
  for (float& w : out) {
    const float error = noise(random);
    if (w > 0) w += error;
  }
  return out;
}

float depthAt(const Frame& frame, int u, int v) { return frame.points[v * frame.width() + u].z(); }

/// Root mean square of the error of inverse depth.
double errorOf(const Frame& frame, const cv::Mat_<float>& truth) {
  double sum = 0;
  for (int i = 0; i < frame.size(); ++i) sum += std::pow(1 / frame.points[i].z() - truth(i), 2);
  return std::sqrt(sum / frame.size());
}

/// Has seen so many frames of the table.
DepthFusion settledFusion(int frames, int threads = 1) {
  DepthFusion fusion(8);
  for (int k = 0; k < frames; ++k) {
    Frame frame = frameOf(noisy(table(), 100 + k));
    fusion.fuse({}, threads, frame);
  }
  return fusion;
}

void expectEqual(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.size(), b.size());
  for (int i = 0; i < a.size(); ++i) {
    const bool none = !(b.points[i].z() > 0);
    ASSERT_EQ(!(a.points[i].z() > 0), none) << i;
    if (none) continue;
    ASSERT_EQ(a.points[i], b.points[i]) << i;
  }
}

}  // namespace

TEST(DepthFusion, OfAStillSceneTakesTheNoiseOut) {
  DepthFusion fusion = settledFusion(11);
  Frame frame = frameOf(noisy(table(), 200));
  EXPECT_NEAR(errorOf(frame, table()), 0.002, 0.0001);
  const FusedDepth fused = fusion.fuse({}, 1, frame);
  EXPECT_FALSE(fused.restarted);
  EXPECT_GT(fused.averaged, 0.97 * frame.size());
  EXPECT_LT(errorOf(frame, table()), 0.5 * 0.002);
  EXPECT_EQ(fusion.memoryBytes(), 6u * kWidth * kHeight);
}

TEST(DepthFusion, IsTheMeanOfInverseDepthWhileFramesAreFew) {
  DepthFusion fusion(8);
  cv::Mat_<double> sum(kHeight, kWidth, 0.0);
  for (int k = 0; k < 5; ++k) {
    const cv::Mat_<float> image = noisy(table(), k, 0.0003f);  // too little for outliers and drifts
    Frame frame = frameOf(image);
    fusion.fuse({}, 1, frame);
    for (int i = 0; i < frame.size(); ++i) sum(i) += image(i);
    for (int i = 0; i < frame.size(); ++i) ASSERT_NEAR(1 / frame.points[i].z(), sum(i) / (k + 1), 1e-6) << k;
  }
}

TEST(DepthFusion, OfOneFrameLeavesFramesAsTheyAre) {
  DepthFusion fusion(1);
  for (int k = 0; k < 3; ++k) {
    const Frame before = frameOf(noisy(table(), k));
    Frame frame = before;
    const FusedDepth fused = fusion.fuse({}, 1, frame);
    EXPECT_EQ(fused.averaged + fused.filled + fused.changed, 0u);
    expectEqual(frame, before);
  }
  EXPECT_EQ(fusion.memoryBytes(), 0u);
}

TEST(DepthFusion, SinglePixelsThatJumpAreLeftOutUntilTheyStay) {
  DepthFusion fusion = settledFusion(8);
  cv::Mat_<float> image = table();
  image(60, 80) = 1.5f;
  for (int k = 0; k < 4; ++k) {
    Frame frame = frameOf(image);
    fusion.fuse({}, 1, frame);
    EXPECT_NEAR(1 / depthAt(frame, 80, 60), k < 2 ? table()(60, 80) : 1.5f, 0.003) << k;
  }
}

TEST(DepthFusion, WhatAppearsIsSeenAtOnce) {
  DepthFusion fusion = settledFusion(8);
  cv::Mat_<float> image = noisy(table(), 300);
  const cv::Rect thing(50, 40, 30, 20);
  image(thing) = 1.3f;
  Frame frame = frameOf(image);
  const FusedDepth fused = fusion.fuse({}, 1, frame);
  EXPECT_GE(fused.changed, static_cast<std::size_t>(thing.area() - 4));
  int wrong = 0;
  for (int v = thing.y; v < thing.br().y; ++v) {
    for (int u = thing.x; u < thing.br().x; ++u) wrong += std::abs(1 / depthAt(frame, u, v) - 1.3f) > 1e-5;
  }
  EXPECT_LE(wrong, 4) << "but for the corners, which have few neighbours";
  // It goes again.
  frame = frameOf(table());
  fusion.fuse({}, 1, frame);
  wrong = 0;
  for (int i = 0; i < frame.size(); ++i) wrong += std::abs(1 / frame.points[i].z() - table()(i)) > 0.006;
  EXPECT_LE(wrong, 4);
}

TEST(DepthFusion, WhatSlidesDoesNotSmear) {
  DepthFusion fusion = settledFusion(8);
  for (int step = 0; step < 20; ++step) {
    cv::Mat_<float> truth = table();
    truth(cv::Rect(20 + 3 * step, 40, 30, 20)) = 1.3f;
    Frame frame = frameOf(noisy(truth, 400 + step));
    fusion.fuse({}, 1, frame);
    int wrong = 0;
    for (int i = 0; i < frame.size(); ++i) wrong += std::abs(1 / frame.points[i].z() - truth(i)) > 0.012;
    EXPECT_LE(wrong, 12) << step;  // corners
  }
}

TEST(DepthFusion, WhatRisesSlowlyIsFollowedWithinTheNoise) {
  DepthFusion fusion = settledFusion(8);
  for (int step = 1; step <= 40; ++step) {
    cv::Mat_<float> truth = table();
    truth(cv::Rect(50, 40, 40, 40)) += 0.0015f * step;
    Frame frame = frameOf(noisy(truth, 500 + step));
    fusion.fuse({}, 1, frame);
    double sum = 0;
    for (int v = 45; v < 75; ++v) {
      for (int u = 55; u < 85; ++u) sum += 1 / depthAt(frame, u, v) - truth(v, u);
    }
    // Three standard deviations from a mean of eight; the noise is measured with what moves in it.
    EXPECT_LT(std::abs(sum / (30 * 30)), 3.3 * 0.002 * std::sqrt(1 + 1 / 8.0)) << step;
  }
}

TEST(DepthFusion, SmallHolesKeepWhatWasMeasured) {
  DepthFusion fusion = settledFusion(8);
  cv::Mat_<float> image = table();
  image(cv::Rect(30, 30, 10, 10)) = 0;
  image(cv::Rect(90, 40, 50, 50)) = 0;
  Frame frame = frameOf(image);
  const FusedDepth fused = fusion.fuse({}, 1, frame);
  EXPECT_NEAR(1 / depthAt(frame, 35, 35), table()(35, 35), 0.004);
  const Eigen::Vector3f filled = frame.points[35 * kWidth + 35];
  EXPECT_LT((frame.camera.project(filled.cast<double>()) - Eigen::Vector2d(35, 35)).norm(), 1e-3);
  EXPECT_FALSE(depthAt(frame, 115, 65) > 0) << "a wide hole is something else";
  EXPECT_GT(fused.filled, 100u);
  // Not for ever.
  for (int k = 0; k < 9; ++k) {
    frame = frameOf(image);
    fusion.fuse({}, 1, frame);
  }
  EXPECT_FALSE(depthAt(frame, 35, 35) > 0);
}

TEST(DepthFusion, AFilledHoleIsNoBridgedPixel) {
  DepthFusion fusion = settledFusion(8);
  Frame frame = frameOf(table());
  const int never = 5 * kWidth + 7, known = 30 * kWidth + 30;
  {
    cv::Mat_<float> image = table();
    image(never) = 0;
    DepthFusion other(8);
    for (int k = 0; k < 3; ++k) {
      frame = frameOf(image);
      frame.points[never] = {0, 0, 1.5f};
      frame.bridged = {never};
      other.fuse({}, 1, frame);
      EXPECT_EQ(frame.bridged, std::vector<int>{never}) << "never measured";
      EXPECT_EQ(frame.points[never].z(), 1.5f);
    }
  }
  frame = frameOf(table());
  frame.points[known].z() = 3;
  frame.bridged = {known};
  fusion.fuse({}, 1, frame);
  EXPECT_TRUE(frame.bridged.empty());
  EXPECT_NEAR(1 / frame.points[known].z(), table()(known), 0.004);
}

TEST(DepthFusion, AMovingCameraIsToldByThePicture) {
  DepthFusion fusion(8);
  for (int k = 0; k < 12; ++k) {
    // Nearer by 8 mm a frame, and turning.
    cv::Mat_<float> image = table();
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) image(v, u) += 0.008f * k + 0.0001f * k * (u - kWidth / 2);
    }
    const Frame before = frameOf(noisy(image, 600 + k));
    Frame frame = before;
    EXPECT_TRUE(fusion.fuse({}, 1, frame).restarted) << k;
    expectEqual(frame, before);
  }
}

TEST(DepthFusion, AMovingCameraIsToldByItsPose) {
  DepthFusion fusion(8);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int k = 0; k < 6; ++k) {
    Frame frame = frameOf(noisy(table(), 700 + k));
    pose.translation().x() += k < 3 ? 0.0001 : 0.002;  // the plane is the same, the camera is not
    EXPECT_EQ(fusion.fuse(pose, 1, frame).restarted, k == 0 || k >= 3) << k;
  }
}

TEST(DepthFusion, ANewSizeOrCameraBeginsAnew) {
  DepthFusion fusion = settledFusion(4);
  Frame frame = frameOf(table()(cv::Rect(0, 0, 100, 80)));
  EXPECT_TRUE(fusion.fuse({}, 1, frame).restarted);
  frame.camera.fx = frame.camera.fy = 200;
  EXPECT_TRUE(fusion.fuse({}, 1, frame).restarted);
  EXPECT_FALSE(fusion.fuse({}, 1, frame).restarted);
  fusion.clear();
  EXPECT_TRUE(fusion.fuse({}, 1, frame).restarted);
}

TEST(DepthFusion, IsTheSameForAnyNumberOfThreads) {
  for (const int threads : {2, 3, 8}) {
    DepthFusion one(8), many(8);
    for (int k = 0; k < 6; ++k) {
      cv::Mat_<float> image = noisy(table(), 800 + k);
      image(cv::Rect(10 * k, 30, 20, 20)) = k % 2 ? 0.f : 1.4f;
      Frame a = frameOf(image), b = a;
      one.fuse({}, 1, a);
      many.fuse({}, threads, b);
      expectEqual(a, b);
    }
  }
}

TEST(DepthFusion, FramesWithoutDepthAreNoCrash) {
  DepthFusion fusion(8);
  const cv::Mat_<float> nothing(kHeight, kWidth, 0.f);
  for (int k = 0; k < 3; ++k) {
    Frame frame = frameOf(nothing);
    fusion.fuse({}, 1, frame);
  }
  Frame frame = frameOf(table());
  const Frame before = frame;
  fusion.fuse({}, 1, frame);
  expectEqual(frame, before);
}

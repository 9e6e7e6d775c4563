// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "scene/resolution.hpp"

using namespace objectness;
using namespace objectness_test;
using Eigen::Vector3f;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A 1280 x 720 camera 0.5 m over a table: pixels of 0.55 mm.
Scene fineScene(int scale = 1) {
  Scene scene;
  scene.camera = {910.0 / scale, 910.0 / scale, 639.5 / scale, 359.5 / scale, 1280 / scale, 720 / scale};
  scene.T_world_camera = lookAt({0, -0.3, 0.4}, {0, 0, 0});
  scene.surfaces = {slab(-0.3, -0.25, 0.3, 0.25, 0), box({-0.12, -0.05, 0}, {-0.04, 0.03, 0.06}),
                    box({0.03, -0.06, 0}, {0.1, 0.02, 0.08})};
  scene.s0 = 0.0002, scene.s2 = 0.0006;
  return scene;
}

/// A plane at that depth, all pixels valid.
Frame level(int width, int height, float z) {
  Frame frame;
  frame.camera = {100, 100, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
  for (int i = 0; i < frame.size(); ++i)
    frame.points.push_back(z * frame.camera.ray(i % width, i / width).cast<float>());
  return frame;
}

}  // namespace

TEST(Resolution, OnlyFinePicturesAreAveraged) {
  ResolutionConfig config;
  EXPECT_EQ(averagedPixels(fineScene().render(), config), 2);
  EXPECT_EQ(averagedPixels(fineScene(2).render(), config), 1) << "pixels of more than 0.8 mm";
  config.min_width_px = 700;
  EXPECT_EQ(averagedPixels(fineScene().render(), config), 1) << "half of 1280 is narrower";
  config = {};
  config.finest_pixel_m = 0;
  EXPECT_EQ(averagedPixels(fineScene().render(), config), 1) << "switched off";
  Frame empty;
  empty.camera = {1000, 1000, 0, 0, 1280, 720};
  empty.points.assign(empty.size(), Vector3f::Constant(kNan));
  EXPECT_EQ(averagedPixels(empty, {}), 1);
  EXPECT_EQ(averagedPixels(level(1920, 1080, 0.02f), {}), 3) << "as far as the width allows";
}

TEST(Resolution, BlocksAreMeansOfOneSurface) {
  // Against the rule by the book, on random depths of two surfaces with holes; the last row and column are cut off.
  std::mt19937 random(3);
  for (const int factor : {2, 3}) {
    Frame frame = level(31, 23, 1);
    for (Vector3f& p : frame.points) {
      const unsigned draw = random() % 10;
      p *= draw == 0 ? kNan : draw < 6 ? 1 + 0.0001f * (random() % 20) : 1.5f + 0.0001f * (random() % 20);
    }
    const Frame coarse = averageBlocks(frame, factor);
    ASSERT_EQ(coarse.width(), (31 + factor - 1) / factor);
    ASSERT_EQ(coarse.height(), (23 + factor - 1) / factor);
    for (int row = 0; row < coarse.height(); ++row) {
      for (int column = 0; column < coarse.width(); ++column) {
        std::vector<double> near, far;
        int pixels = 0;
        for (int v = row * factor; v < std::min(23, (row + 1) * factor); ++v) {
          for (int u = column * factor; u < std::min(31, (column + 1) * factor); ++u, ++pixels) {
            const float z = frame.points[v * 31 + u].z();
            if (z > 0) (z < 1.25f ? near : far).push_back(z);
          }
        }
        const std::size_t valid = near.size() + far.size();
        const Vector3f& point = coarse.points[row * coarse.width() + column];
        if (2 * valid < static_cast<std::size_t>(pixels) || valid == 0) {
          EXPECT_TRUE(std::isnan(point.z()));
          continue;
        }
        const std::vector<double>& taken = 2 * near.size() >= valid ? near : far;
        double mean = 0;
        for (const double z : taken) mean += z / taken.size();
        EXPECT_NEAR(point.z(), mean, 1e-6);
        // The ray through the middle of a whole block, in the fine picture.
        const Eigen::Vector3d ray =
            frame.camera.ray(column * factor + 0.5 * (factor - 1), row * factor + 0.5 * (factor - 1));
        EXPECT_NEAR(point.x() / point.z(), ray.x(), 1e-6);
        EXPECT_NEAR(point.y() / point.z(), ray.y(), 1e-6);
      }
    }
  }
}

TEST(Resolution, PixelsFindTheBlockOfTheirSurface) {
  // Two surfaces meet within a column of blocks: every pixel's block has the pixel's depth.
  Frame frame = level(20, 12, 1);
  for (int i = 0; i < frame.size(); ++i) {
    if (i % 20 >= 9) frame.points[i] *= 1.4f;
  }
  frame.points[0] = Vector3f::Constant(kNan);
  const Frame coarse = averageBlocks(frame, 2);
  const std::vector<int> blocks = blocksOf(frame, coarse, 2);
  EXPECT_EQ(blocks[0], -1);
  for (int i = 1; i < frame.size(); ++i) {
    ASSERT_GE(blocks[i], 0) << i;
    EXPECT_NEAR(coarse.points[blocks[i]].z(), frame.points[i].z(), 1e-5) << i;
    EXPECT_LE(std::abs(blocks[i] % 10 - i % 20 / 2), 1);
    EXPECT_LE(std::abs(blocks[i] / 10 - i / 20 / 2), 1);
  }
}

TEST(Resolution, OnlyBlocksOfBridgedPixelsAreBridged) {
  Frame frame = level(8, 4, 1);
  frame.bridged = {0, 1, 8, 9, 4};
  EXPECT_EQ(averageBlocks(frame, 2).bridged, std::vector<int>{0});
}

TEST(Resolution, ResultsHaveTheInputsSize) {
  Scene scene = fineScene();
  const Frame frame = scene.render();
  const Segmentation result = segment(frame, {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const cv::Size size(1280, 720);
  EXPECT_EQ(result.labels.size(), size);
  EXPECT_EQ(result.object_points.mask.size(), size);
  EXPECT_EQ(result.object_points.on_table.size(), size);
  EXPECT_EQ(result.object_points.height_m.size(), size);
  EXPECT_EQ(result.edges.kinds.size(), size);
  EXPECT_EQ(result.superpixels.label.size(), size);
  ASSERT_EQ(result.segments.size(), 2u);
  for (const Segment& found : result.segments) {
    EXPECT_TRUE(std::is_sorted(found.pixels.begin(), found.pixels.end()));
    for (const int surface : {1, 2}) {
      int shared = 0, all = 0;
      for (const int pixel : found.pixels) shared += scene.seen[pixel] == surface;
      for (const int seen : scene.seen) all += seen == surface;
      if (shared > all / 2) {
        EXPECT_GT(2.0 * shared / (all + found.pixels.size()), 0.97);
      }
    }
  }
  EXPECT_GT(result.table.d, 0.3);
}

TEST(Resolution, FailuresHaveTheInputsSizeToo) {
  Scene scene = fineScene();
  scene.surfaces = {sphere({0, 0, 0}, 0.15)};
  const Segmentation result = segment(scene.render(), {});
  EXPECT_FALSE(result.status.ok());
  EXPECT_EQ(result.labels.size(), cv::Size(1280, 720));
  EXPECT_EQ(cv::countNonZero(result.labels), 0);
  std::atomic<bool> cancel{true};
  const Segmentation cancelled = segment(fineScene().render(), {}, &cancel);
  EXPECT_EQ(cancelled.status.code, StatusCode::kCancelled);
  EXPECT_EQ(cancelled.labels.size(), cv::Size(1280, 720));
}

TEST(Resolution, ResultsDoNotDependOnTheThreads) {
  const Frame frame = fineScene().render();
  Config config;
  config.runtime.threads = 1;
  const Segmentation one = segment(frame, config);
  config.runtime.threads = 4;
  EXPECT_EQ(cv::countNonZero(one.labels != segment(frame, config).labels), 0);
}

TEST(Resolution, LabelsOfBlocksAreThoseOfTheirMiddle) {
  cv::Mat_<ushort> labels(5, 7);
  for (int i = 0; i < 35; ++i) labels(i / 7, i % 7) = static_cast<ushort>(i);
  const cv::Mat_<ushort> by_two = labelsOfBlocks(labels, 2), by_three = labelsOfBlocks(labels, 3);
  ASSERT_EQ(by_two.size(), cv::Size(4, 3));
  EXPECT_EQ(by_two(0, 0), 8);
  EXPECT_EQ(by_two(1, 2), 3 * 7 + 5);
  EXPECT_EQ(by_two(2, 3), 4 * 7 + 6) << "of a block that the picture's end cuts off, the last pixel";
  ASSERT_EQ(by_three.size(), cv::Size(3, 2));
  EXPECT_EQ(by_three(0, 0), 8);
  EXPECT_EQ(cv::countNonZero(labelsOfBlocks(labels, 1) != labels), 0);
}

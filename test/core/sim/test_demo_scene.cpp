// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "fixtures/demo_images.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "sim/intersect.hpp"

using namespace objectness;
using namespace objectness::sim;

TEST(DemoScene, HasEveryObjectAndItsShadow) {
  const SceneImages scene = demoImages(1);
  std::map<int, int> pixels;
  for (const ushort label : scene.true_labels) ++pixels[label];
  for (const int label : {1, 20, 30, 40, 50, 60, 70}) EXPECT_GT(pixels[label], 1500) << label;
  EXPECT_EQ(pixels.size(), 8u);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) ASSERT_TRUE(scene.true_labels(v, u) == 0 || scene.depth_mm(v, u) > 0);
  }
}

TEST(DemoScene, SeedDecidesEverything) {
  const SceneImages a = demoImages(5), b = demoImages(5), c = demoImages(6);
  EXPECT_EQ(cv::countNonZero(a.depth_mm != b.depth_mm), 0);
  EXPECT_GT(cv::countNonZero(a.depth_mm != c.depth_mm), 10000);
}

TEST(DemoScene, ObjectsNeverTouch) {
  // Seen from straight below, every object's outline is apart from the others': rays through one hit no other.
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const std::vector<Body> bodies = makeDemoScene(seed).bodies;
    for (double x = -0.5; x < 0.5; x += 0.004) {
      for (double y = -0.3; y < 0.4; y += 0.004) {
        int hit = 0;
        for (const Body& body : bodies) {
          const Eigen::Isometry3d T_body_world = body.T_world_body.inverse();
          const Ray ray{T_body_world * Eigen::Vector3d(x, y, 1), {1e-9, 1e-9, -1}};
          hit += body.label >= 20 && intersect(body.shape, ray);
        }
        ASSERT_LE(hit, 1) << "seed " << seed << " at " << x << ", " << y;
      }
    }
  }
}

TEST(DemoScene, EveryObjectIsSegmented) {
  const SceneImages scene = demoImages(1);
  const Result<Frame> frame = makeFrame(scene.depth_mm, scene.color, scene.camera, InputConfig());
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  const Segmentation result = segment(frame.value, Config());
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.segments.size(), 6u);
  for (int label = 20; label <= 70; label += 10) {
    double best = 0;
    for (std::size_t k = 0; k < result.segments.size(); ++k) {
      const cv::Mat found = result.labels == static_cast<ushort>(k + 2), truth = scene.true_labels == label;
      best =
          std::max(best, 2.0 * cv::countNonZero(found & truth) / (cv::countNonZero(found) + cv::countNonZero(truth)));
    }
    EXPECT_GT(best, 0.85) << "Dice of object " << label;
  }
}

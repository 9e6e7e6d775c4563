// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/sim/demo_scene.hpp"
#include "objectness_segmentation/sim/depth_sensor.hpp"

using namespace objectness;
using namespace objectness::sim;
using Eigen::Vector3d;
namespace sim = objectness::sim;

TEST(Shapes, BoxAndCylinderFromAboveAndBeside) {
  const sim::Box box{{0.2, 0.4, 0.3}};
  const auto top = intersect(box, {{0.05, 0.1, 2}, {0, 0, -1}});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->t, 1.7, 1e-12);
  EXPECT_TRUE(top->normal.isApprox(Vector3d::UnitZ()));
  const auto side = intersect(box, {{-1, 0.1, 0.1}, {2, 0, 0}});
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->t, 0.45, 1e-12);
  EXPECT_TRUE(side->normal.isApprox(-Vector3d::UnitX()));
  EXPECT_FALSE(intersect(box, {{-1, 0.3, 0.1}, {1, 0, 0}}));

  const Cylinder cylinder{0.1, 0.3};
  EXPECT_NEAR(intersect(cylinder, {{0, 0, 1}, {0, 0, -1}})->t, 0.7, 1e-12);
  const auto wall = intersect(cylinder, {{0.06, -1, 0.2}, {0, 1, 0}});
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->t, 1 - 0.08, 1e-12);
  EXPECT_TRUE(wall->normal.isApprox(Vector3d(0.6, -0.8, 0), 1e-9));
  EXPECT_FALSE(intersect(cylinder, {{0, -1, 0.31}, {0, 1, 0}}));
}

TEST(Shapes, BowlIsHollow) {
  const Bowl bowl{0.1, 0.08, 0.01, 0.09};
  const auto inside = intersect(bowl, {{0, 0, 1}, {0, 0, -1}});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(1 - inside->t, 0.01, 1e-12) << "the inner floor, one wall over the foot";
  EXPECT_TRUE(inside->normal.isApprox(Vector3d::UnitZ()));
  const double inner = std::sqrt(0.09 * 0.09 - 0.01 * 0.01), outer = std::sqrt(0.1 * 0.1 - 0.01 * 0.01);
  EXPECT_NEAR(intersect(bowl, {{(inner + outer) / 2, 0, 1}, {0, 0, -1}})->t, 1 - 0.08, 1e-12) << "the rim";
  EXPECT_FALSE(intersect(bowl, {{outer + 1e-3, 0, 1}, {0, 0, -1}}));
  const auto wall = intersect(bowl, {{-1, 0, 0.05}, {1, 0, 0}});
  EXPECT_NEAR(wall->t, 1 - std::sqrt(0.01 - 0.04 * 0.04), 1e-12);
}

TEST(DepthSensor, NoiseAndStepsOfAWall) {
  Body wall{sim::Box{{20, 0.1, 20}}, Eigen::Isometry3d::Identity(), {200, 200, 200}, 1};
  wall.T_world_body.translation() = Vector3d(0, 1.55, -10);  // its face is at y = 1.5
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const DepthSensor sensor;
  const SceneImages picture = takePicture({wall}, pose, sensor, 3);
  std::map<ushort, int> histogram;
  double sum = 0, squares = 0;
  for (const ushort depth : picture.depth_mm) {
    ++histogram[depth];
    sum += depth, squares += double(depth) * depth;
  }
  const double count = 640 * 480, mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  EXPECT_NEAR(mean, 1500, 0.5);
  EXPECT_NEAR(deviation, std::hypot(1000 * sensor.sigma(1.5), 7.1 / std::sqrt(12)), 0.3);
  const double step = 1500.0 * 1.5 / (525 * 0.075) / 8;  // 7.1 mm
  ushort last = 0;
  for (const auto& [depth, pixels] : histogram) {
    if (last > 0) {
      EXPECT_NEAR(depth - last, step, 1.1) << pixels << " pixels";
    }
    last = depth;
  }
}

TEST(DemoScene, HasEveryObjectAndItsShadow) {
  const SceneImages scene = makeDemoScene(1);
  std::map<int, int> pixels;
  for (const ushort label : scene.true_labels) ++pixels[label];
  for (const int label : {1, 20, 30, 40, 50, 60, 70}) EXPECT_GT(pixels[label], 1500) << label;
  EXPECT_EQ(pixels.size(), 8u);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) ASSERT_TRUE(scene.true_labels(v, u) == 0 || scene.depth_mm(v, u) > 0);
  }
}

TEST(DemoScene, SeedDecidesEverything) {
  const SceneImages a = makeDemoScene(5), b = makeDemoScene(5), c = makeDemoScene(6);
  EXPECT_EQ(cv::countNonZero(a.depth_mm != b.depth_mm), 0);
  EXPECT_GT(cv::countNonZero(a.depth_mm != c.depth_mm), 10000);
}

TEST(DemoScene, ObjectsNeverTouch) {
  // Seen from straight below, every object's outline is apart from the others': rays through one hit no other.
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const std::vector<Body> bodies = demoBodies(seed);
    for (double x = -0.5; x < 0.5; x += 0.004) {
      for (double y = -0.3; y < 0.4; y += 0.004) {
        int hit = 0;
        for (std::size_t k = 2; k < bodies.size(); ++k) {
          hit += castRay({bodies[k]}, {{x, y, 1}, {1e-9, 1e-9, -1}}).body != nullptr;
        }
        ASSERT_LE(hit, 1) << "seed " << seed << " at " << x << ", " << y;
      }
    }
  }
}

TEST(DemoScene, EveryObjectIsSegmented) {
  const SceneImages scene = makeDemoScene(1);
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

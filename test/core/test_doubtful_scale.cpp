// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// A table with two boxes, `scale` times as large as it is.
std::vector<std::string> remarksOf(double scale) {
  Scene scene;
  scene.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  scene.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0), box({-0.21, -0.04, 0}, {-0.09, 0.06, 0.14}),
                    box({0.08, -0.02, 0}, {0.22, 0.08, 0.10})};
  Frame frame = scene.render();
  for (Eigen::Vector3f& p : frame.points) p *= static_cast<float>(scale);
  return segment(frame, {}).report.remarks;
}

}  // namespace

TEST(DoubtfulScale, IsARemarkWhenTheTableIsTooFarOrTooNear) {
  EXPECT_TRUE(remarksOf(1).empty());
  EXPECT_TRUE(remarksOf(0.5).empty());
  EXPECT_TRUE(remarksOf(1.8).empty());
  for (const double scale : {5.0, 10.0, 0.2}) {
    const std::vector<std::string> remarks = remarksOf(scale);
    ASSERT_EQ(remarks.size(), 1u) << scale;
    EXPECT_NE(remarks[0].find("--depth-scale"), std::string::npos) << remarks[0];
  }
}

TEST(DoubtfulScale, IsARemarkWithoutATableToo) {
  Frame frame;
  frame.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  std::mt19937 random(1);
  for (int i = 0; i < frame.size(); ++i) {
    frame.points.push_back((frame.camera.ray(i % 320, i / 320) * (4.5 + random() / 4294967296.0)).cast<float>());
  }
  const Segmentation result = segment(frame, {});
  EXPECT_EQ(result.status.code, StatusCode::kNoTable);
  ASSERT_EQ(result.report.remarks.size(), 1u);
  EXPECT_NE(result.report.remarks[0].find("half of what is seen is farther than"), std::string::npos);
}

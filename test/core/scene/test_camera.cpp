// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "scene/recover_camera.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

RawCloud cloudOf(const Frame& frame) { return {frame.width(), frame.height(), frame.points, {}}; }

Frame tableView() {
  Scene scene;
  scene.surfaces = {slab(-0.5, -0.5, 0.5, 0.5, 0), box({-0.1, -0.1, 0}, {0.1, 0.1, 0.15})};
  return scene.render();
}

}  // namespace

TEST(Camera, AcceptsAPinholeCamera) { EXPECT_TRUE(validate(kinect()).ok()); }

TEST(Camera, NamesWhatIsWrong) {
  const auto expectBad = [](PinholeCamera camera, const std::string& word) {
    const Status status = validate(camera);
    EXPECT_EQ(status.code, StatusCode::kBadCamera);
    EXPECT_NE(status.message.find(word), std::string::npos) << status.message;
  };
  PinholeCamera camera = kinect();
  expectBad({}, "size");
  camera.fx = 0;
  expectBad(camera, "focal");
  camera.fx = std::nan("");
  expectBad(camera, "finite");
  camera = kinect(), camera.cy = -1e5;
  expectBad(camera, "principal point");
  camera = kinect(), camera.width = 1 << 20;
  expectBad(camera, "size");
}

TEST(Camera, RefusesImagesThatFillTheMemoryAndFocalLengthsThatOverflow) {
  EXPECT_TRUE(validate(PinholeCamera{3000, 3000, 2047.5, 1535.5, 4096, 3072}).ok());
  EXPECT_NE(validate(PinholeCamera{3000, 3000, 8191.5, 8191.5, 16384, 16384}).message.find("pixels in all"),
            std::string::npos);
  for (const double focal : {1e-310, 0.1, 1e9}) {
    EXPECT_EQ(validate(PinholeCamera{focal, 525, 319.5, 239.5, 640, 480}).code, StatusCode::kBadCamera) << focal;
    EXPECT_EQ(validate(PinholeCamera{525, focal, 319.5, 239.5, 640, 480}).code, StatusCode::kBadCamera) << focal;
  }
}

TEST(Camera, ProjectIsTheInverseOfRay) {
  const PinholeCamera camera{600, 610, 300, 250, 640, 480};
  const Eigen::Vector2d pixel = camera.project(camera.ray(12, 345) * 0.7);
  EXPECT_NEAR(pixel.x(), 12, 1e-9);
  EXPECT_NEAR(pixel.y(), 345, 1e-9);
}

TEST(RecoverCamera, FindsTheIntrinsicsOfAGrid) {
  const Result<PinholeCamera> camera = recoverCamera(cloudOf(tableView()));
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  EXPECT_NEAR(camera.value.fx, 525, 0.01);
  EXPECT_NEAR(camera.value.fy, 525, 0.01);
  EXPECT_NEAR(camera.value.cx, 319.5, 0.01);
  EXPECT_NEAR(camera.value.cy, 239.5, 0.01);
  EXPECT_EQ(camera.value.width, 640);
  EXPECT_EQ(camera.value.height, 480);
}

TEST(RecoverCamera, RefusesAGridThatIsNoPinholeView) {
  RawCloud cloud = cloudOf(tableView());
  for (Eigen::Vector3f& p : cloud.points) p = Eigen::Vector3f(p.z(), -p.x(), -p.y());  // x forward, z up
  for (Eigen::Vector3f& p : cloud.points) p.z() += 2.0f;
  const Result<PinholeCamera> camera = recoverCamera(cloud);
  EXPECT_EQ(camera.status.code, StatusCode::kBadCamera);
  EXPECT_NE(camera.status.message.find("optical frame"), std::string::npos) << camera.status.message;
}

TEST(RecoverCamera, SpinningSensorsAreNotSaidToBeMovedCameras) {
  RawCloud cloud{360, 60, {}, {}};
  for (int i = 0; i < 360 * 60; ++i) {
    const float azimuth = 3.14159F / 180 * (i % 360 - 180), elevation = 0.01F * (i / 360 - 30);
    const float range = 2 + 0.5F * std::sin(3 * azimuth) + 0.2F * std::cos(7 * elevation);
    cloud.points.emplace_back(range * std::cos(elevation) * std::cos(azimuth),
                              -range * std::cos(elevation) * std::sin(azimuth), -range * std::sin(elevation));
  }
  const Result<PinholeCamera> camera = recoverCamera(cloud);
  EXPECT_EQ(camera.status.code, StatusCode::kBadCamera);
  EXPECT_NE(camera.status.message.find("no pinhole view in the optical frame"), std::string::npos)
      << camera.status.message;
}

TEST(RecoverCamera, RefusesTooFewPointsAndSingleColumns) {
  RawCloud cloud = cloudOf(tableView());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (i % 640 != 320) cloud.points[i].setConstant(nan);
  }
  EXPECT_EQ(recoverCamera(cloud).status.code, StatusCode::kBadCamera);
  for (Eigen::Vector3f& p : cloud.points) p.setConstant(nan);
  EXPECT_EQ(recoverCamera(cloud).status.code, StatusCode::kBadCamera);
}

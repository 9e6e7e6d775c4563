// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <image_geometry/pinhole_camera_model.h>

#include <cmath>

#include "fixtures/ros_messages.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"
#include "ros/scene_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::PinholeCamera;
using objectness::StatusCode;

const PinholeCamera kCamera{525.5, 524.5, 320.25, 238.75, 640, 480};

TEST(CameraInput, TakesP) {
  sensor_msgs::CameraInfo message = toCameraInfo(kCamera, makeHeader());
  message.K = {1, 0, 2, 0, 3, 4, 0, 0, 1};  // of the raw image: not the cloud's
  const auto camera = toPinholeCamera(message);
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  EXPECT_EQ(camera.value.fx, 525.5);
  EXPECT_EQ(camera.value.fy, 524.5);
  EXPECT_EQ(camera.value.cx, 320.25);
  EXPECT_EQ(camera.value.cy, 238.75);
  EXPECT_EQ(camera.value.width, 640);
  EXPECT_EQ(camera.value.height, 480);
}

TEST(CameraInput, TakesKWhenThereIsNoP) {
  sensor_msgs::CameraInfo message = toCameraInfo(kCamera, makeHeader());
  message.P.fill(0);
  const auto camera = toPinholeCamera(message);
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  EXPECT_EQ(camera.value.fx, 525.5);
  EXPECT_EQ(camera.value.cy, 238.75);
}

TEST(CameraInput, AppliesRegionOfInterestAndBinningAsImageGeometry) {
  sensor_msgs::CameraInfo message = toCameraInfo(kCamera, makeHeader());
  message.roi.x_offset = 100;
  message.roi.y_offset = 60;
  message.roi.width = 320;
  message.roi.height = 240;
  message.binning_x = 2;
  message.binning_y = 4;
  image_geometry::PinholeCameraModel model;
  ASSERT_TRUE(model.fromCameraInfo(message));
  const auto camera = toPinholeCamera(message);
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  EXPECT_DOUBLE_EQ(camera.value.fx, model.fx());
  EXPECT_DOUBLE_EQ(camera.value.fy, model.fy());
  EXPECT_DOUBLE_EQ(camera.value.cx, model.cx());
  EXPECT_DOUBLE_EQ(camera.value.cy, model.cy());
  EXPECT_EQ(camera.value.width, model.reducedResolution().width);
  EXPECT_EQ(camera.value.height, model.reducedResolution().height);
}

TEST(CameraInput, SaysWhatIsKnownOfTheLens) {
  sensor_msgs::CameraInfo message = toCameraInfo(kCamera, makeHeader());
  message.distortion_model = "plumb_bob";
  message.D = {-0.2, 0.05, 0, 0, 0};
  const auto unclear = toImageCamera(message);
  ASSERT_TRUE(unclear.ok()) << unclear.status.message;
  EXPECT_FALSE(unclear.value.lens);
  EXPECT_EQ(unclear.value.remarks.size(), 1u);
  message.P.fill(0);
  const auto raw = toImageCamera(message);
  ASSERT_TRUE(raw.ok()) << raw.status.message;
  EXPECT_TRUE(raw.value.lens.has_value());
  message.distortion_model = "mirror";
  EXPECT_EQ(toImageCamera(message).status.message.find("camera_info: the distortion model 'mirror'"), 0u);
  EXPECT_TRUE(toPinholeCamera(message).ok()) << "a cloud's points are what they are";
}

void expectBad(const sensor_msgs::CameraInfo& message) {
  const auto camera = toPinholeCamera(message);
  EXPECT_EQ(camera.status.code, StatusCode::kBadCamera);
  EXPECT_NE(camera.status.message.find("camera_info"), std::string::npos) << camera.status.message;
}

TEST(CameraInput, RefusesWhatIsNoCamera) {
  expectBad(sensor_msgs::CameraInfo());  // an uncalibrated driver sends zeros

  sensor_msgs::CameraInfo message = toCameraInfo(kCamera, makeHeader());
  message.P[0] = NAN;
  expectBad(message);
  message.P.fill(0);
  message.K[4] = NAN;
  expectBad(message);
  message.K[4] = INFINITY;
  expectBad(message);

  message = toCameraInfo(kCamera, makeHeader());
  message.P[5] = 0;
  expectBad(message);
  message.P[5] = -500;
  expectBad(message);

  message = toCameraInfo(kCamera, makeHeader());
  message.width = 0;
  expectBad(message);
  message.width = 0xFFFFFFFF;
  expectBad(message);

  message = toCameraInfo(kCamera, makeHeader());
  message.binning_x = 1000000;
  expectBad(message);
}

}  // namespace

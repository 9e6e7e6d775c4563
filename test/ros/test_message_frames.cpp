// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <cmath>

#include "fixtures/depth_message.hpp"
#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"
#include "ros/scene_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::StatusCode;

/// A wall at one metre, as the small frame's camera sees it.
InputMessages wall(int width = 40, int height = 30) {
  InputMessages messages;
  objectness::PinholeCamera camera{50, 50, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
  messages.depth = boost::make_shared<sensor_msgs::Image>(
      makeDepth(std::vector<std::uint16_t>(std::size_t(width) * height, 1000), width, "16UC1"));
  messages.camera_info = boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(camera, makeHeader()));
  return messages;
}

sensor_msgs::ImageConstPtr makeColor(int width, int height, const char* encoding, int channels) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->width = static_cast<std::uint32_t>(width);
  image->height = static_cast<std::uint32_t>(height);
  image->encoding = encoding;
  image->step = static_cast<std::uint32_t>(width * channels);
  image->data.assign(std::size_t(image->step) * height, 0);
  for (std::size_t i = 0; i < image->data.size(); i += channels) image->data[i] = 200;
  return image;
}

TEST(DepthFrame, IsTheSameAsTheCloud) {
  const InputMessages messages = wall();
  EXPECT_EQ(messages.header(), makeHeader());
  const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_EQ(result.frame.width(), 40);
  for (int i = 0; i < result.frame.size(); ++i) {
    const Eigen::Vector3d expected = result.frame.camera.ray(i % 40, i / 40);
    EXPECT_TRUE(result.frame.points[i].cast<double>().isApprox(expected, 1e-6)) << i;
  }
  EXPECT_TRUE(result.remarks.empty());
}

TEST(DepthFrame, TakesColourWhenItFits) {
  InputMessages messages = wall();
  messages.color = makeColor(40, 30, "rgb8", 3);
  SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_FALSE(result.frame.color.empty());
  EXPECT_EQ(result.frame.color(0, 0), cv::Vec3b(0, 0, 200));
  EXPECT_TRUE(result.remarks.empty());
  messages.color = makeColor(40, 30, "mono8", 1);
  result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_FALSE(result.frame.color.empty());
  EXPECT_EQ(result.frame.color(0, 0), cv::Vec3b(200, 200, 200));
}

TEST(DepthFrame, ColourThatDoesNotFitIsARemark) {
  const std::pair<sensor_msgs::ImageConstPtr, const char*> cases[] = {
      {makeColor(80, 60, "rgb8", 3), "80 x 60"},
      {makeColor(40, 30, "rgb99", 3), "rgb99"},
      {makeColor(40, 30, "rgb8", 2), "rgb"},
      {boost::make_shared<sensor_msgs::Image>(), "empty"}};
  const SegmentedFrame plain = segmentMessages(wall(), {}, {}, nullptr);
  for (const auto& [color, word] : cases) {
    InputMessages messages = wall();
    messages.color = color;
    const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
    EXPECT_EQ(result.segmentation.status.code, plain.segmentation.status.code);
    EXPECT_EQ(result.frame.size(), plain.frame.size());
    EXPECT_TRUE(result.frame.color.empty());
    ASSERT_EQ(result.remarks.size(), 1u) << word;
    EXPECT_NE(result.remarks[0].find(word), std::string::npos) << result.remarks[0];
  }
}

TEST(DepthFrame, RegionOfInterestAndBinningAreThoseOfTheImage) {
  InputMessages messages = wall(20, 10);
  auto camera =
      boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo({100, 100, 79.5, 59.5, 160, 120}, makeHeader()));
  camera->roi.x_offset = 60;
  camera->roi.y_offset = 50;
  camera->roi.width = 40;
  camera->roi.height = 20;
  camera->binning_x = camera->binning_y = 2;
  messages.camera_info = camera;
  const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_EQ(result.frame.width(), 20) << result.segmentation.status.message;
  EXPECT_NEAR(result.frame.points[0].x(), (0 - 9.75) / 50, 1e-6);
  EXPECT_NEAR(result.frame.points[0].y(), (0 - 4.75) / 50, 1e-6);
}

TEST(DepthFrame, ThatIsThinnedOutTakesTheWholeCamera) {
  InputMessages messages = wall(20, 15);
  messages.camera_info = wall(40, 30).camera_info;
  const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_EQ(result.frame.width(), 20) << result.segmentation.status.message;
  EXPECT_EQ(result.frame.camera.fx, 25);
  ASSERT_EQ(result.remarks.size(), 1u);
  EXPECT_NE(result.remarks[0].find("one row and column in 2"), std::string::npos) << result.remarks[0];
}

TEST(DepthFrame, ThatIsCertainlyNotRectifiedIsRectified) {
  for (const bool certain : {true, false}) {
    InputMessages messages = wall(160, 120);
    auto camera = boost::make_shared<sensor_msgs::CameraInfo>(*messages.camera_info);
    camera->distortion_model = "plumb_bob";
    camera->D = {-0.05, 0, 0, 0, 0};
    if (certain) camera->P.fill(0);
    messages.camera_info = camera;
    const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
    ASSERT_EQ(result.frame.width(), 160) << result.segmentation.status.message;
    EXPECT_EQ(result.frame.rectified, certain);
    ASSERT_EQ(result.remarks.size(), 1u);
    EXPECT_NE(result.remarks[0].find("distortion"), std::string::npos) << result.remarks[0];
  }
}

TEST(DepthFrame, UnitsOfTheDriverAreAParameter) {
  objectness::Config config;
  config.input.depth_unit_m = 0.0005;
  const SegmentedFrame result = segmentMessages(wall(), config, {}, nullptr);
  ASSERT_GT(result.frame.size(), 0);
  EXPECT_FLOAT_EQ(result.frame.points[0].z(), 0.5F);
}

TEST(LargeInputs, AreThinnedAndSpokenOfInTheirOwnPixels) {
  objectness_test::Scene scene;
  const objectness::PinholeCamera camera{1312.5, 1312.5, 799.5, 599.5, 1600, 1200};  // five times 320 x 240
  scene.camera = camera;
  scene.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0), box({-0.1, -0.05, 0}, {0.1, 0.05, 0.12})};
  const objectness::Frame full = scene.render();
  ASSERT_LT(full.size(), kMaxPixels);
  ASSERT_GT(4 * full.size(), kMaxPixels);
  // Twice as wide and high: every point twice, so that half of them are the frame.
  objectness::Frame doubled;
  doubled.camera = {2 * camera.fx, 2 * camera.fy, 2 * camera.cx, 2 * camera.cy, 3200, 2400};
  doubled.points.resize(doubled.size());
  for (int i = 0; i < doubled.size(); ++i) doubled.points[i] = full.points[i / 3200 / 2 * 1600 + i % 3200 / 2];

  InputMessages messages;
  messages.cloud = boost::make_shared<sensor_msgs::PointCloud2>(toCloudMessage(doubled, makeHeader()));
  messages.camera_info = boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(doubled.camera, makeHeader()));
  const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_TRUE(result.segmentation.status.ok()) << result.segmentation.status.message;
  ASSERT_EQ(result.frame.width(), 1600);
  ASSERT_EQ(result.remarks.size(), 1u);
  EXPECT_NE(result.remarks[0].find("one in 2 "), std::string::npos) << result.remarks[0];
  ASSERT_EQ(result.segmentation.segments.size(), 1u);

  const SegmentedObjectArray objects = toObjectsMessage(result, makeHeader());
  const sensor_msgs::Image labels = toLabelImage(result, makeHeader());
  ASSERT_EQ(labels.width, 3200u);
  ASSERT_EQ(labels.height, 2400u);
  int own = 0;
  for (const int pixel : objects.objects[0].indices.indices) {
    own += scene.seen[pixel / 3200 / 2 * 1600 + pixel % 3200 / 2] == 1;
    EXPECT_EQ(labels.data[2 * pixel], 2);
  }
  EXPECT_GT(own, 0.95 * objects.objects[0].indices.indices.size());

  cv::Mat depth(2400, 3200, CV_32FC1);
  for (int i = 0; i < doubled.size(); ++i) depth.at<float>(i / 3200, i % 3200) = doubled.points[i].z();
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->encoding = "32FC1";
  image->width = 3200;
  image->height = 2400;
  image->step = 4 * image->width;
  image->data.assign(depth.data, depth.data + std::size_t{image->step} * image->height);
  messages.depth = image;
  messages.cloud.reset();
  const SegmentedFrame of_depth = segmentMessages(messages, {}, {}, nullptr);
  ASSERT_EQ(of_depth.frame.width(), 1600) << of_depth.segmentation.status.message;
  EXPECT_EQ(of_depth.segmentation.segments.size(), 1u);
}

TEST(DepthFrame, NeedsACameraOfItsSize) {
  InputMessages messages = wall();
  messages.camera_info.reset();
  EXPECT_EQ(segmentMessages(messages, {}, {}, nullptr).segmentation.status.code, StatusCode::kBadCamera);
  messages.camera_info = wall(50, 30).camera_info;
  EXPECT_EQ(segmentMessages(messages, {}, {}, nullptr).segmentation.status.code, StatusCode::kSizeMismatch);
}

TEST(CloudFrame, InAnotherFrameIsNamedByItsFrameId) {
  objectness::Frame frame = makeSmallFrame(40, 30);
  for (Eigen::Vector3f& p : frame.points) p = Eigen::Vector3f(p.z(), -p.x(), -p.y());
  InputMessages messages;
  messages.cloud = boost::make_shared<sensor_msgs::PointCloud2>(toCloudMessage(frame, makeHeader(1, "camera_link")));
  for (const bool with_camera : {true, false}) {
    if (with_camera) {
      messages.camera_info = boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(frame.camera, makeHeader()));
    } else {
      messages.camera_info.reset();
    }
    const objectness::Status status = segmentMessages(messages, {}, {}, nullptr).segmentation.status;
    EXPECT_EQ(status.code, StatusCode::kBadCamera);
    EXPECT_NE(status.message.find("'camera_link' is not the camera's optical frame"), std::string::npos)
        << status.message;
  }
}

TEST(CloudFrame, OfALensThatMayMatterHasARemark) {
  const objectness::Frame frame = makeSmallFrame(400, 300);
  InputMessages messages;
  messages.cloud = boost::make_shared<sensor_msgs::PointCloud2>(toCloudMessage(frame, makeHeader()));
  for (const bool with_p : {true, false}) {
    auto camera = boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(frame.camera, makeHeader()));
    camera->distortion_model = "plumb_bob";
    camera->D = {-0.3, 0, 0, 0, 0};
    if (!with_p) camera->P.fill(0);
    messages.camera_info = camera;
    const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
    ASSERT_EQ(result.frame.width(), 400) << result.segmentation.status.message;
    ASSERT_GE(result.remarks.size(), 1u);
    EXPECT_NE(result.remarks[0].find("lens distortion, up to"), std::string::npos) << result.remarks[0];
  }
}

TEST(CloudFrame, WithoutCameraHasItsIntrinsicsRecovered) {
  const objectness::Frame frame = makeSmallFrame(40, 30);
  InputMessages messages;
  messages.cloud = boost::make_shared<sensor_msgs::PointCloud2>(toCloudMessage(frame, makeHeader()));
  const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
  EXPECT_NEAR(result.frame.camera.fx, frame.camera.fx, 0.1);
  EXPECT_NEAR(result.frame.camera.cy, frame.camera.cy, 0.1);
  ASSERT_EQ(result.remarks.size(), 1u);
  EXPECT_NE(result.remarks[0].find("publish camera_info"), std::string::npos);
}

}  // namespace

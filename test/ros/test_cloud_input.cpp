// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/ros_messages.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"
#include "ros/scene_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::StatusCode;

void expectSame(const objectness::RawCloud& cloud, const objectness::Frame& frame, bool with_colors) {
  ASSERT_EQ(cloud.width, frame.width());
  ASSERT_EQ(cloud.height, frame.height());
  ASSERT_EQ(cloud.points.size(), frame.points.size());
  ASSERT_EQ(cloud.colors.size(), with_colors ? frame.points.size() : 0);
  for (int i = 0; i < frame.size(); ++i) {
    if (std::isnan(frame.points[i].z())) {
      EXPECT_TRUE(std::isnan(cloud.points[i].z())) << i;
    } else {
      EXPECT_EQ(cloud.points[i], frame.points[i]) << i;
    }
    if (with_colors) {
      EXPECT_EQ(cloud.colors[i], frame.color(i / frame.width(), i % frame.width())) << i;
    }
  }
}

TEST(CloudInput, ReadsEveryLayout) {
  const objectness::Frame frame = makeSmallFrame();
  const Layout pcl;
  Layout compact{0, 4, 8, 12, 16, 0, true, "rgb"};
  Layout shuffled{21, 5, 13, 1, 40, 7, true, "rgba"};  // unaligned, reordered, padded points and rows
  for (const Layout& layout : {pcl, compact, shuffled}) {
    const auto cloud = toRawCloud(makeCloudMessage(frame, layout));
    ASSERT_TRUE(cloud.ok()) << cloud.status.message;
    expectSame(cloud.value, frame, true);
  }
}

TEST(CloudInput, ReadsWhatSceneMessagesWrite) {
  objectness::Frame frame = makeSmallFrame();
  for (const bool with_color : {true, false}) {
    if (!with_color) frame.color.release();
    const sensor_msgs::PointCloud2 message = toCloudMessage(frame, makeHeader());
    EXPECT_EQ(message.header, makeHeader());
    const auto cloud = toRawCloud(message);
    ASSERT_TRUE(cloud.ok()) << cloud.status.message;
    expectSame(cloud.value, frame, with_color);
  }
}

TEST(CloudInput, WorksWithoutColour) {
  const objectness::Frame frame = makeSmallFrame();
  Layout layout{0, 4, 8, 0, 12, 0, false, ""};
  const auto cloud = toRawCloud(makeCloudMessage(frame, layout));
  ASSERT_TRUE(cloud.ok()) << cloud.status.message;
  expectSame(cloud.value, frame, false);
}

TEST(CloudInput, DoesNotUseAColourFieldThatIsNone) {
  sensor_msgs::PointCloud2 message = makeCloudMessage(makeSmallFrame());
  message.fields[3].datatype = sensor_msgs::PointField::UINT8;
  auto cloud = toRawCloud(message);
  ASSERT_TRUE(cloud.ok());
  EXPECT_TRUE(cloud.value.colors.empty());
  message.fields[3].datatype = sensor_msgs::PointField::UINT32;
  message.fields[3].offset = message.point_step - 3;
  cloud = toRawCloud(message);
  ASSERT_TRUE(cloud.ok());
  EXPECT_TRUE(cloud.value.colors.empty());
}

TEST(CloudInput, InvalidPointsStayInvalid) {
  objectness::Frame frame = makeSmallFrame();
  frame.points[2].setConstant(std::numeric_limits<float>::infinity());
  frame.points[3].setConstant(-std::numeric_limits<float>::infinity());
  const auto cloud = toRawCloud(makeCloudMessage(frame));
  ASSERT_TRUE(cloud.ok());
  EXPECT_TRUE(std::isnan(cloud.value.points[1].x()));
  EXPECT_TRUE(std::isinf(cloud.value.points[2].x()));
  EXPECT_TRUE(std::isinf(cloud.value.points[3].x()));
}

/// A message that must be refused, with a word that its reason has to hold.
void expectBad(const sensor_msgs::PointCloud2& message, const std::string& word) {
  const auto cloud = toRawCloud(message);
  EXPECT_EQ(cloud.status.code, StatusCode::kBadInput) << word;
  EXPECT_NE(cloud.status.message.find(word), std::string::npos) << cloud.status.message;
}

TEST(CloudInput, RefusesMessagesThatContradictThemselves) {
  const sensor_msgs::PointCloud2 good = makeCloudMessage(makeSmallFrame());
  ASSERT_TRUE(toRawCloud(good).ok());

  sensor_msgs::PointCloud2 message = good;
  message.is_bigendian = true;
  expectBad(message, "big-endian");

  message = good;
  message.row_step = message.width * message.point_step - 1;
  expectBad(message, "row_step");

  message = good;
  message.data.pop_back();
  expectBad(message, "carries");

  message = good;
  message.point_step = 11;
  expectBad(message, "point_step");

  message = good;
  message.fields[0].offset = 0xFFFFFFFF;
  expectBad(message, "'z'");

  message = good;
  message.fields[1].datatype = sensor_msgs::PointField::FLOAT64;
  expectBad(message, "FLOAT32");

  message = good;
  message.fields.erase(message.fields.begin());
  expectBad(message, "no field 'z'");

  expectBad(sensor_msgs::PointCloud2(), "no field");
}

TEST(CloudInput, RefusesAbsurdSizes) {
  sensor_msgs::PointCloud2 message = makeCloudMessage(makeSmallFrame());
  message.width = message.height = 0xFFFFFFFF;
  expectBad(message, "row_step");
  message.row_step = 0xFFFFFFFF;
  message.point_step = 12;
  message.width = 0x10000000;
  expectBad(message, "carries");
  message.width = 0;
  expectBad(message, "empty");
}

TEST(CloudInput, RowsThatFollowOneAnotherNeedNoRowStep) {
  const objectness::Frame frame = makeSmallFrame();
  sensor_msgs::PointCloud2 message = makeCloudMessage(frame);
  message.row_step = 0;
  const auto cloud = toRawCloud(message);
  ASSERT_TRUE(cloud.ok()) << cloud.status.message;
  expectSame(cloud.value, frame, true);
  message.data.pop_back();
  expectBad(message, "carries");
  message.width = message.height = message.point_step = 0xFFFFFFFF;
  expectBad(message, "carries");
}

TEST(CloudInput, KeepsTheNameOfItsFrame) {
  EXPECT_EQ(toRawCloud(makeCloudMessage(makeSmallFrame())).value.frame_id, "camera_optical_frame");
}

TEST(CloudInput, RowStepOfASingleRowIsNotNeeded) {
  sensor_msgs::PointCloud2 message = makeCloudMessage(makeSmallFrame(5, 1));
  message.row_step = 0;
  EXPECT_TRUE(toRawCloud(message).ok());
}

}  // namespace

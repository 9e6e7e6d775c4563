// SPDX-License-Identifier: BSD-3-Clause
// Part of the test of features.test: what the nodelet takes.
#include "features_fixture.hpp"
#include "log_listener.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

TEST_F(Features, TakesDepthImages) {
  ros::param::set("/second/input", "depth");
  const SecondNodelet second(
      SecondNodelet::Names{{"depth", "/d435/depth"}, {"camera_info", "/d435/camera_info"}, {"rgb", "/d435/rgb"}});
  ASSERT_TRUE(second.loaded());
  const ros::Publisher depths = nh_.advertise<Image>("/d435/depth", 5), colors = nh_.advertise<Image>("/d435/rgb", 5);
  const ros::Publisher cameras = nh_.advertise<sensor_msgs::CameraInfo>("/d435/camera_info", 5);
  EXPECT_FALSE(waitUntil([&] { return depths.getNumSubscribers() + colors.getNumSubscribers() > 0; }, 0.5));
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] {
    return objects.connected() && depths.getNumSubscribers() > 0 && cameras.getNumSubscribers() > 0 &&
           colors.getNumSubscribers() > 0;
  }));
  struct Case {
    const char* encoding;
    int color_width;  ///< 0: none
    int status;
    std::size_t fields;  ///< of an object's cloud
  };
  const Case cases[] = {{"16UC1", 0, SegmentedObjectArray::OK, 3},
                        {"32FC1", 0, SegmentedObjectArray::OK, 3},
                        {"32FC1", 320, SegmentedObjectArray::OK, 4},
                        {"16UC1", 100, SegmentedObjectArray::OK, 3},
                        {"8UC1", 0, SegmentedObjectArray::BAD_INPUT, 0}};
  for (const Case& expected : cases) {
    const Image depth = depthImage(expected.encoding);
    sensor_msgs::CameraInfo camera = goodCamera();
    camera.header = depth.header;
    if (expected.color_width > 0) {
      Image color;
      color.header = depth.header;
      color.encoding = "rgb8";
      color.width = static_cast<std::uint32_t>(expected.color_width);
      color.height = 240;
      color.step = 3 * color.width;
      color.data.assign(std::size_t{color.step} * color.height, 77);
      colors.publish(color);
      ros::WallDuration(0.3).sleep();  // it may come on the heels of the depth image, and need not be waited for
    }
    cameras.publish(camera);
    depths.publish(depth);
    const auto result = objects.wait(depth.header.stamp);
    ASSERT_TRUE(result) << expected.encoding;
    EXPECT_EQ(result->status, expected.status) << result->message;
    ASSERT_EQ(result->objects.size(), expected.status == SegmentedObjectArray::OK ? 2u : 0u);
    for (const auto& object : result->objects) EXPECT_EQ(object.cloud.fields.size(), expected.fields);
    ros::WallDuration(0.2).sleep();
  }
}

TEST_F(Features, TakesCloudsAloneWhenThereIsNoCameraInfo) {
  const SecondNodelet second(SecondNodelet::Names{{"points", points()}, {"camera_info", "/nobody/camera_info"}});
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return objects.connected() && cloud_publisher_.getNumSubscribers() > 0; }));
  SegmentedObjectArrayConstPtr result;
  for (int i = 0; i < 20 && !result; ++i) {
    const PointCloud2 cloud = goodCloud();
    cloud_publisher_.publish(cloud);
    result = objects.wait(cloud.header.stamp, 0.5);
  }
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  EXPECT_EQ(result->objects.size(), 2u);
}

TEST_F(Features, SaysOnceThatATopicIsWrong) {
  LogListener log;
  const SecondNodelet second(SecondNodelet::Names{{"points", "/nowhere/points"}, {"camera_info", cameraInfo()}});
  ASSERT_TRUE(second.loaded());
  ASSERT_TRUE(waitUntil([&] { return log.connected(); }));
  const Listener<SegmentedObjectArray> objects("/second/objects");
  const char* sentence = "no messages on /nowhere/points, which nobody publishes: remap it to the camera's topic";
  EXPECT_TRUE(waitUntil([&] { return log.count(sentence) > 0; }, 20));
  EXPECT_FALSE(waitUntil([&] { return log.count(sentence) > 1; }, 3));
}

}  // namespace

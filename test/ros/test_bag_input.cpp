// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include "fixtures/bag_files.hpp"
#include "fixtures/ros_messages.hpp"
#include "fixtures/temporary_folder.hpp"
#include "ros/bag_input.hpp"
#include "ros/scene_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

class Bags : public testing::Test {
 protected:
  /// So many clouds, organized or not, on a topic.
  void addClouds(const std::string& topic, int count, bool organized = true) {
    sensor_msgs::PointCloud2 cloud = toCloudMessage(makeSmallFrame(), makeHeader());
    if (!organized) {
      cloud.width *= cloud.height;
      cloud.height = 1;
      cloud.row_step = cloud.width * cloud.point_step;
    }
    for (int i = 0; i < count; ++i) bag_.write(topic, ros::Time(1 + i), cloud);
  }
  void addCamera(const std::string& topic) {
    bag_.write(topic, ros::Time(1), toCameraInfo(makeSmallFrame().camera, makeHeader()));
  }
  void addImages(const std::string& topic, const std::string& encoding, int count,
                 const std::string& frame = "camera_optical_frame") {
    sensor_msgs::Image image;
    image.header = makeHeader(1234.5, frame);
    image.encoding = encoding;
    image.width = 4;
    image.height = 3;
    for (int i = 0; i < count; ++i) bag_.write(topic, ros::Time(1 + i), image);
  }
  void addText(const std::string& topic) { bag_.write(topic, ros::Time(1), std_msgs::String()); }

  objectness::Result<InputTopics> choose(const InputTopics& wanted = {}) {
    bag_.close();
    const auto input = BagInput::open(path_, wanted);
    if (!input.ok()) return objectness::Result<InputTopics>::error(input.status);
    return {{}, input.value->topics()};
  }
  void expectError(const objectness::Status& status, const std::vector<std::string>& texts) const {
    EXPECT_EQ(status.code, objectness::StatusCode::kBadInput);
    for (const std::string& text : texts) EXPECT_NE(status.message.find(text), std::string::npos) << status.message;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "in.bag";
  rosbag::Bag bag_{path_, rosbag::bagmode::Write};
};

TEST_F(Bags, TopicsAreFound) {
  addClouds("/left/depth/points", 2);
  addClouds("/right/depth/points", 3);
  addClouds("/lidar/points", 9, false);
  addCamera("/left/depth/camera_info");
  addCamera("/right/depth/camera_info");
  addCamera("/right/rgb/camera_info");
  const auto topics = choose();
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.points, "/right/depth/points");
  EXPECT_EQ(topics.value.camera_info, "/right/depth/camera_info");
}

TEST_F(Bags, TopicsAreThoseThatAreGiven) {
  addClouds("/a/points", 2);
  addClouds("/b/points", 1, false);
  addCamera("/a/camera_info");
  addCamera("/b/camera_info");
  const auto topics = choose({"/b/points", "/a/camera_info", "", ""});
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.points, "/b/points");
  EXPECT_EQ(topics.value.camera_info, "/a/camera_info");
}

TEST_F(Bags, WithoutCloudsAreNamedWithWhatTheyHold) {
  addText("/chatter");
  addCamera("/camera_info");
  expectError(choose().status, {"no sensor_msgs/PointCloud2 on any topic", "/chatter (std_msgs/String, 1)",
                                "/camera_info (sensor_msgs/CameraInfo, 1)"});
}

TEST_F(Bags, WithoutCameraAreTakenWhenTheirCloudsAreOrganized) {
  addClouds("/points", 4);
  const auto topics = choose();
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.points, "/points");
  EXPECT_EQ(topics.value.camera_info, "");
}

TEST_F(Bags, WithoutTheCameraThatIsGiven) {
  addClouds("/points", 4);
  expectError(choose({"", "/camera_info", "", ""}).status,
              {"no sensor_msgs/CameraInfo on /camera_info", "/points (sensor_msgs/PointCloud2, 4)"});
}

TEST_F(Bags, OfDepthImages) {
  addImages("/device/depth/image_raw", "16UC1", 5);
  addImages("/device/depth/image_rect", "32FC1", 5);
  addImages("/device/labels", "16UC1", 9);
  addImages("/device/ir", "mono16", 9);
  addImages("/device/color", "bgr8", 9, "another_frame");
  addClouds("/lidar", 20, false);
  addCamera("/device/depth/camera_info");
  addCamera("/device/rgb/camera_info");
  const auto topics = choose();
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.depth, "/device/depth/image_rect");
  EXPECT_EQ(topics.value.camera_info, "/device/depth/camera_info");
  EXPECT_EQ(topics.value.points, "");
  EXPECT_EQ(topics.value.color, "");
}

TEST_F(Bags, OfDepthImagesWithPictures) {
  addImages("/device/depth/image_rect", "16UC1", 9, "depth_frame");
  addImages("/device/aligned_depth/image", "16UC1", 5);
  addImages("/device/color/image", "rgb8", 5);
  addImages("/device/infra/image", "mono8", 9);
  addCamera("/device/depth/camera_info");
  addCamera("/device/aligned_depth/camera_info");
  const auto topics = choose();
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.depth, "/device/aligned_depth/image");
  EXPECT_EQ(topics.value.camera_info, "/device/aligned_depth/camera_info");
  EXPECT_EQ(topics.value.color, "/device/color/image");
}

TEST_F(Bags, OfDepthImagesThatAreAskedFor) {
  addClouds("/points", 2);
  addImages("/a", "16UC1", 2);
  addImages("/depth", "16UC1", 2);
  addImages("/b", "bgr8", 2, "another_frame");
  addCamera("/camera_info");
  const auto topics = choose({"", "", "/a", "/b"});
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.depth, "/a");
  EXPECT_EQ(topics.value.color, "/b");
  EXPECT_EQ(topics.value.camera_info, "/camera_info");
  EXPECT_EQ(choose({"", "", "", "/b"}).value.depth, "/depth");
  expectError(choose({"", "", "/c", ""}).status, {"no sensor_msgs/Image on /c"});
  expectError(choose({"", "", "/a", "/c"}).status, {"no sensor_msgs/Image on /c"});
}

TEST_F(Bags, OfDepthImagesWithoutCamera) {
  addImages("/depth", "16UC1", 2);
  expectError(choose().status, {"depth images need a camera_info", "/depth (sensor_msgs/Image, 2)"});
}

TEST_F(Bags, WithoutMessages) { expectError(choose().status, {"no sensor_msgs/PointCloud2", "no messages"}); }

TEST_F(Bags, WithoutTheTopicThatIsGiven) {
  addClouds("/points", 1);
  addCamera("/camera_info");
  expectError(choose({"/camera_info", "", "", ""}).status, {"no sensor_msgs/PointCloud2 on /camera_info", "/points"});
}

TEST_F(Bags, OfListsOfPoints) {
  addClouds("/few", 1, false);
  addClouds("/lidar", 2, false);
  expectError(choose().status, {"not organized", "camera_info", "/lidar (sensor_msgs/PointCloud2, 2)"});
  expectError(choose({"/few", "", "", ""}).status, {"not organized", "camera_info"});
}

TEST_F(Bags, OfListsOfPointsWithACamera) {
  addClouds("/few", 1, false);
  addClouds("/lidar", 2, false);
  addCamera("/camera_info");
  const auto topics = choose();
  ASSERT_TRUE(topics.ok()) << topics.status.message;
  EXPECT_EQ(topics.value.points, "/lidar");
  EXPECT_EQ(topics.value.camera_info, "/camera_info");
}

TEST_F(Bags, ThatAreNone) {
  bag_.close();
  expectError(BagInput::open(folder_ / "none.bag", {}).status, {"no such file"});
  expectError(BagInput::open(folder_.path(), {}).status, {"is a folder"});
  writeBytes(path_, "");
  expectError(BagInput::open(path_, {}).status, {"is no bag of ROS 1"});
  writeBytes(path_, "SQLite format 3, as bags of ROS 2 are");
  expectError(BagInput::open(path_, {}).status, {"is no bag of ROS 1"});
}

TEST_F(Bags, CutOff) {
  addClouds("/points", 50);
  addCamera("/camera_info");
  bag_.close();
  const std::string whole = readBytes(path_);
  for (const double share : {0.001, 0.01, 0.5, 0.9, 0.999}) {
    writeBytes(path_, whole.substr(0, static_cast<std::size_t>(share * whole.size())));
    expectError(BagInput::open(path_, {}).status, {"is damaged or cut off: "});
  }
}

TEST_F(Bags, WhoseRecordingWasBrokenOff) {
  addClouds("/points", 500);
  // Still open: the head knows of no index yet.
  const std::string copy = folder_ / "copy.bag";
  std::filesystem::copy_file(path_, copy);
  expectError(BagInput::open(copy, {}).status, {"has no index", "rosbag reindex"});
}

}  // namespace

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "fixtures/bag_files.hpp"
#include "fixtures/ros_messages.hpp"
#include "fixtures/small_scene.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/scene_bag_writer.hpp"
#include "ros/scene_messages.hpp"
#include "ros/segment_bag.hpp"

namespace objectness_test {

using namespace objectness_segmentation;

class SegmentBag : public testing::Test {
 protected:
  SegmentBag() { settings_.config.search.angle_step_deg = 30; }

  void writeScenes(int frames) const {
    SceneBagSettings settings;
    settings.sensor = smallSensor();
    settings.frames = frames;
    ASSERT_TRUE(writeSceneBag(in_, smallScene(), settings).ok());
  }

  /// Clouds of a flat nothing and their cameras at these stamps.
  void writePlain(const std::vector<double>& clouds, const std::vector<double>& cameras) const {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (const double stamp : clouds) writeCloud(bag, recorded_, makeHeader(stamp));
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      writeCamera(bag, recorded_, makeHeader(cameras[i]), static_cast<int>(i));
    }
  }
  static void writeCloud(rosbag::Bag& bag, const ros::Time& recorded, const std_msgs::Header& header) {
    bag.write("points", recorded, toCloudMessage(makeSmallFrame(), header));
  }
  static void writeCamera(rosbag::Bag& bag, const ros::Time& recorded, const std_msgs::Header& header, int number) {
    objectness::PinholeCamera camera = makeSmallFrame().camera;
    camera.fx += number;  // to tell them apart
    bag.write("camera_info", recorded, toCameraInfo(camera, header));
  }

  /// Index of the camera_info that each cloud gets, -1 for none.
  std::vector<int> pairs(bool approximate) const {
    const auto input = BagInput::open(in_, {});
    EXPECT_TRUE(input.ok()) << input.status.message;
    std::vector<int> cameras;
    const auto status = input.value->forEachFrame(approximate, [&](const InputMessages& messages, const ros::Time&) {
      const auto& camera = messages.camera_info;
      cameras.push_back(camera ? static_cast<int>(camera->K[0] - makeSmallFrame().camera.fx) : -1);
      return true;
    });
    EXPECT_TRUE(status.ok()) << status.message;
    return cameras;
  }

  SegmentBagReport segment(const std::string& out) {
    const auto input = BagInput::open(in_, {});
    EXPECT_TRUE(input.ok()) << input.status.message;
    BagOutput output(out);
    frames_.clear();
    const auto report =
        segmentBag(*input.value, settings_, output, [this](const BagFrame& frame) { frames_.push_back(frame); });
    EXPECT_TRUE(output.close().ok());
    return report;
  }

  /// In metres.
  static sensor_msgs::Image depthOf(const sensor_msgs::PointCloud2& cloud) {
    sensor_msgs::Image image;
    image.header = cloud.header;
    image.width = cloud.width;
    image.height = cloud.height;
    image.encoding = "32FC1";
    image.step = 4 * image.width;
    for (sensor_msgs::PointCloud2ConstIterator<float> z(cloud, "z"); z != z.end(); ++z) {
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(&*z);
      image.data.insert(image.data.end(), bytes, bytes + 4);
    }
    return image;
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.bag", out_ = folder_ / "out.bag";
  const ros::Time recorded_{77};
  SegmentBagSettings settings_;
  std::vector<BagFrame> frames_;
};

}  // namespace objectness_test

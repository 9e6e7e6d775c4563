// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <string>
#include <vector>

#include "bag_player.hpp"
#include "fixtures/bag_files.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/scene_bag_writer.hpp"
#include "sim/demo_scene.hpp"
#include "wait_until.hpp"

namespace objectness_test {

namespace bag_topics = objectness_segmentation::bag_topics;
using objectness_segmentation::SegmentedObjectArray;
using objectness_segmentation::SegmentedObjectArrayConstPtr;

constexpr double kPatience_s = 120;  // wall time; much more than any machine needs

/// The demo scene from a camera that moves for 3 s, played to the node; and what the node answers.
class Playback : public testing::Test {
 protected:
  static constexpr int kFrames = 16;
  static constexpr double kRate_hz = 5;

  /// Once for all tests.
  static const std::string& bag() {
    static const TemporaryFolder folder;
    static const std::string path = [] {
      objectness_segmentation::SceneBagSettings settings;
      settings.sensor.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};  // a quarter of the pixels: quicker
      settings.frames = kFrames;
      settings.rate_hz = kRate_hz;
      const auto status = writeSceneBag(folder / "moving camera.bag", objectness::sim::makeDemoScene(1), settings);
      EXPECT_TRUE(status.ok()) << status.message;
      return folder / "moving camera.bag";
    }();
    return path;
  }

  void SetUp() override {
    ASSERT_FALSE(bag().empty());
    subscriber_ = nh_.subscribe<SegmentedObjectArray>(
        "/segment_objects/objects", 1000,
        [this](const SegmentedObjectArrayConstPtr& answer) { answers_.push_back(answer); });
    ASSERT_TRUE(waitUntil([&] { return subscriber_.getNumPublishers() > 0; }, kPatience_s));
  }

  static std::vector<std::string> play(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), {bag(), "--topics", bag_topics::kPoints, bag_topics::kCameraInfo});
    return arguments;
  }
  /// A player that ends at once takes with it what it has not sent yet: it stays until it is ended. It would not loop.
  static std::vector<std::string> playOnce(std::vector<std::string> options) {
    options.push_back("--keep-alive");
    return play(options);
  }
  static std::vector<ros::Time> playedStamps() {
    std::vector<ros::Time> stamps;
    for (const auto& info : readAll<sensor_msgs::CameraInfo>(bag(), bag_topics::kCameraInfo)) {
      stamps.push_back(info->header.stamp);
    }
    return stamps;
  }
  /// Dropped frames count from the start of the node: plays the first frame alone to read how many they are. Forgets
  /// its answer.
  std::uint32_t droppedSoFar() {
    BagPlayer first(playOnce({"-u", "0.1"}));
    EXPECT_TRUE(waitForAnswerTo(playedStamps().front()));
    const std::uint32_t dropped = answers_.empty() ? 0 : answers_.back()->dropped_frames;
    answers_.clear();
    return dropped;
  }
  bool waitForAnswerTo(const ros::Time& stamp) {
    return waitUntil([&] { return !answers_.empty() && answers_.back()->header.stamp == stamp; }, kPatience_s);
  }

  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
  std::vector<SegmentedObjectArrayConstPtr> answers_;
};

}  // namespace objectness_test

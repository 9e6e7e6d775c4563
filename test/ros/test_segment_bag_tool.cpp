// SPDX-License-Identifier: BSD-3-Clause
// The command line of segment_bag, run as a user runs it.
#include <gtest/gtest.h>

#include "fixtures/bag_files.hpp"
#include "fixtures/leaf_model.hpp"
#include "fixtures/ros_messages.hpp"
#include "fixtures/small_scene.hpp"
#include "fixtures/tool_test.hpp"
#include "objectness_segmentation/SegmentedObjectArray.h"
#include "ros/scene_bag_writer.hpp"
#include "ros/scene_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

class SegmentBagTool : public ToolTest {
 protected:
  Outcome run(const std::string& arguments) const { return ToolTest::run("segment_bag", arguments); }
  void writeScenes(int frames) const {
    SceneBagSettings settings;
    settings.sensor = smallSensor();
    settings.frames = frames;
    ASSERT_TRUE(writeSceneBag(in_, smallScene(), settings).ok());
  }
  void expectFailure(const std::string& arguments, int exit_status, const std::string& text) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_status, exit_status) << arguments;
    EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  }

  const std::string in_ = folder_ / "in.bag", out_ = folder_ / "out.bag";
  /// The coarse angles make it quick.
  const std::string usual_ = "--set search.angle_step_deg=30 --out " + out_ + " " + in_;
};

TEST_F(SegmentBagTool, AnswersEveryCloud) {
  writeScenes(3);
  const Outcome outcome = run("--threads 1 --seed 5 " + usual_);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* text : {"clouds /camera/depth_registered/points, camera /camera/depth_registered/camera_info\n",
                           "cloud 2/3, stamp 1000.100000000: 2 objects, ", "3 of 3 clouds answered: "}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << outcome.out;
  }
  EXPECT_EQ(readAll<SegmentedObjectArray>(out_, "/segment_objects/objects").size(), 3u);
}

TEST_F(SegmentBagTool, TakesAModelOfOnesOwn) {
  writeScenes(1);
  writeBytes(folder_ / "leaf.json", objectness::toJson(leafModel(0, 0, 0.75f)));
  ASSERT_EQ(run("--model " + (folder_ / "leaf.json") + " " + usual_).exit_status, 0);
  const auto objects = readAll<SegmentedObjectArray>(out_, "/segment_objects/objects");
  ASSERT_EQ(objects.size(), 1u);
  ASSERT_GE(objects[0]->objects.size(), 2u);
  for (const auto& object : objects[0]->objects) EXPECT_EQ(object.objectness, 0.75f);

  expectFailure("--model " + (folder_ / "none.json") + " " + usual_, 2, "none.json: there is no such file");
  writeBytes(folder_ / "foreign.json", "{\"contact\": 3}");
  expectFailure("--model " + (folder_ / "foreign.json") + " " + usual_, 2, "foreign.json: \"contact\" is no forest");
}

TEST_F(SegmentBagTool, SaysWhichCamerasAreTakenWhereStampsDoNotPair) {
  const objectness::Frame frame = makeSmallFrame();
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (const double stamp : {1.0, 2.0}) bag.write("points", ros::Time(1), toCloudMessage(frame, makeHeader(stamp)));
    bag.write("points", ros::Time(1), toCloudMessage(frame, makeHeader(3.0, "another_frame")));
    bag.write("info", ros::Time(1), toCameraInfo(frame.camera, makeHeader(1.0)));
  }
  const Outcome outcome = run(usual_);
  EXPECT_EQ(outcome.exit_status, 0);
  for (const char* text : {"1 cloud(s) of points have no camera_info of their stamp on info: the last one",
                           "1 cloud(s) of points have no camera_info of their stamp or frame_id on info: the camera"}) {
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(outcome.errorLines(), 2) << outcome.err;
  EXPECT_EQ(readAll<SegmentedObjectArray>(out_, "/segment_objects/objects").size(), 3u);
  const Outcome approximate = run("--approximate-sync " + usual_);
  EXPECT_EQ(approximate.exit_status, 0);
  EXPECT_EQ(approximate.err, "");
  EXPECT_NE(approximate.out.find("3 of 3 clouds answered, 3 of them not segmented"), std::string::npos)
      << approximate.out;
}

TEST_F(SegmentBagTool, TakesDepthImages) {
  sensor_msgs::Image depth;
  depth.header = makeHeader(1.0);
  depth.encoding = "16UC1";
  depth.width = 4;
  depth.height = 3;
  depth.step = 8;
  depth.data.assign(24, 1);
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    bag.write("depth", ros::Time(1), depth);
    bag.write("info", ros::Time(1), toCameraInfo(makeSmallFrame().camera, makeHeader(1.0)));
    depth.encoding = "bgr8";
    bag.write("color", ros::Time(1), depth);
  }
  for (const std::string options : {"", "--depth depth --rgb color --camera-info info "}) {
    const Outcome outcome = run(options + usual_);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    for (const char* text : {"depth images depth, pictures color, camera info\n", "depth image 1/1, stamp 1.0",
                             "1 of 1 depth images answered"}) {
      EXPECT_NE(outcome.out.find(text), std::string::npos) << outcome.out;
    }
  }
}

TEST_F(SegmentBagTool, InputThatCannotBeUsedLeavesTheOutputAlone) {
  writeBytes(out_, "of an earlier run");
  expectFailure(usual_, 1, in_ + ": there is no such file");
  writeBytes(in_, "no bag");
  expectFailure(usual_, 1, in_ + ": is no bag of ROS 1");
  writeScenes(1);
  expectFailure("--points /tf " + usual_, 1, "holds no sensor_msgs/PointCloud2 on /tf, but ");
  expectFailure("--depth /tf " + usual_, 1, "holds no sensor_msgs/Image on /tf, but ");
  expectFailure("--camera-info /none " + usual_, 1, "holds no sensor_msgs/CameraInfo on /none, but ");
  EXPECT_EQ(readBytes(out_), "of an earlier run");
}

TEST_F(SegmentBagTool, OutputThatCannotBeWritten) {
  writeScenes(1);
  expectFailure("--out " + (folder_ / "none/out.bag") + " " + in_, 1, "none/out.bag: cannot be written");
  expectFailure("--out /dev/full --set search.angle_step_deg=30 " + in_, 1, "--out /dev/full: cannot be written");
}

TEST_F(SegmentBagTool, WrongCommandLines) {
  writeScenes(1);
  expectFailure("", 2, "one IN.bag is needed, not 0");
  expectFailure("--out o.bag a.bag b.bag", 2, "one IN.bag is needed, not 2");
  expectFailure(in_, 2, "no --out OUT.bag given");
  expectFailure("--out " + folder_.path() + "/./in.bag " + in_, 2, "would overwrite the input");
  expectFailure("--set serach.angle_step_deg=3 " + usual_, 2, "did you mean search.angle_step_deg?");
  expectFailure("--points /a --depth /b " + usual_, 2, "--points and --depth exclude each other");
  expectFailure("--points /a --rgb /b " + usual_, 2, "--rgb belongs to depth images");
  expectFailure("--approx " + usual_, 2, "unrecognised option '--approx'");
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_status, 0);
  for (const char* text :
       {"--points", "--camera-info", "--depth", "--rgb", "--approximate-sync", "--config", "Exit status"}) {
    EXPECT_NE(help.out.find(text), std::string::npos) << text;
  }
}

}  // namespace

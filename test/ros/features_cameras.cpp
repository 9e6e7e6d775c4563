// SPDX-License-Identifier: BSD-3-Clause
// Part of the test of features.test: camera_infos that do not come with the inputs.
#include <map>

#include "features_fixture.hpp"
#include "log_listener.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

struct Kind {
  const char* name;
  bool depth, approximate;
};

/// A nodelet with inputs of its own, clouds or depth images, which are sent at 10 Hz.
class Cameras : public Features, public testing::WithParamInterface<Kind> {
 protected:
  static constexpr double kPeriod_s = 0.1;

  void SetUp() override {
    Features::SetUp();
    ros::param::set("/second/input", GetParam().depth ? "depth" : "points");
    ros::param::set("/second/approximate_sync", GetParam().approximate);
    second_ = std::make_unique<SecondNodelet>(
        SecondNodelet::Names{{"points", "/own/points"}, {"depth", "/own/depth"}, {"camera_info", "/own/camera_info"}});
    ASSERT_TRUE(second_->loaded());
    inputs_ = GetParam().depth ? nh_.advertise<Image>("/own/depth", 5) : nh_.advertise<PointCloud2>("/own/points", 5);
    cameras_ = nh_.advertise<sensor_msgs::CameraInfo>("/own/camera_info", 5, true);
    answers_subscriber_ = nh_.subscribe<SegmentedObjectArray>("/second/objects", 1000,
                                                              [this](const SegmentedObjectArrayConstPtr& answer) {
                                                                answers_[answer->header.stamp] = answer;
                                                                last_ = answer;
                                                              });
    ASSERT_TRUE(waitUntil([&] {
      return answers_subscriber_.getNumPublishers() > 0 && inputs_.getNumSubscribers() > 0 &&
             cameras_.getNumSubscribers() > 0 && log_.connected();
    }));
  }

  void sendCamera(const ros::Time& stamp, const std::string& frame = "some_camera/optical_frame") {
    sensor_msgs::CameraInfo camera = objectness_segmentation::toCameraInfo(scene_.camera, {});
    camera.header.stamp = stamp;
    camera.header.frame_id = frame;
    cameras_.publish(camera);
  }
  /// Without its camera_info; waits until the next one is due.
  ros::Time send(std_msgs::Header header = nextHeader()) {
    if (GetParam().depth) {
      Image image = depthImage("32FC1");
      image.header = header;
      inputs_.publish(image);
    } else {
      inputs_.publish(makeCloudMessage(frame_, {}, header));
    }
    waitUntil([] { return false; }, kPeriod_s);
    return header.stamp;
  }
  bool answered(const ros::Time& stamp, double seconds = 10) {
    return waitUntil([&] { return answers_.count(stamp) > 0; }, seconds);
  }
  /// Until inputs are not kept waiting any more.
  void sendUntilAtOnce() {
    for (int i = 0; i < 100 && log_.count(kWarning) == 0; ++i) send();
    EXPECT_EQ(log_.count(kWarning), 1);
    for (int i = 0; i < 5; ++i) send();
  }
  void expectTwoObjects(const ros::Time& stamp) {
    ASSERT_TRUE(answered(stamp)) << stamp;
    EXPECT_EQ(answers_[stamp]->status, SegmentedObjectArray::OK) << answers_[stamp]->message;
    EXPECT_EQ(answers_[stamp]->objects.size(), 2u) << stamp;
  }

  static constexpr const char* kWarning = ": the last one of their frame_id is used";

  LogListener log_;
  std::unique_ptr<SecondNodelet> second_;
  ros::Publisher inputs_, cameras_;
  ros::Subscriber answers_subscriber_;
  std::map<ros::Time, SegmentedObjectArrayConstPtr> answers_;
  SegmentedObjectArrayConstPtr last_;
};

TEST_P(Cameras, OnceLatchedAndWithoutStampAreEnough) {
  sendCamera(ros::Time());
  sendUntilAtOnce();
  answers_.clear();
  for (int i = 0; i < 5; ++i) {
    const ros::Time stamp = send();
    expectTwoObjects(stamp);
  }
  EXPECT_EQ(log_.count(kWarning), 1) << "said once";
  EXPECT_EQ(log_.count("approximate_sync"), 0);
}

TEST_P(Cameras, ServeASingleInput) {
  sendCamera(ros::Time(1));
  expectTwoObjects(send());
}

TEST_P(Cameras, AtOneHertzDoNotSlowDownTheResults) {
  const auto sendSecond = [&] {
    std_msgs::Header header = nextHeader();
    sendCamera(header.stamp);
    ros::Time last = send(header);
    for (int i = 1; i < 10; ++i) last = send();
    return last;
  };
  for (int i = 0; i < 4; ++i) sendSecond();
  ros::Time last = send();
  ASSERT_TRUE(answered(last));
  const std::uint32_t dropped = last_->dropped_frames;
  answers_.clear();
  for (int i = 0; i < 3; ++i) last = sendSecond();
  ASSERT_TRUE(answered(last));
  EXPECT_EQ(answers_.size() + answers_[last]->dropped_frames - dropped, 30u) << "each input was taken";
  EXPECT_EQ(log_.count(kWarning), 1);
  for (const auto& [stamp, answer] : answers_) EXPECT_EQ(answer->objects.size(), 2u) << stamp << answer->message;
}

TEST_P(Cameras, WithoutStampMayChange) {
  sendCamera(ros::Time());
  sendUntilAtOnce();
  expectTwoObjects(send());
  scene_.camera = {131.25, 131.25, 79.5, 59.5, 160, 120};
  frame_ = scene_.render();
  sendCamera(ros::Time());
  waitUntil([] { return false; }, 0.3);
  expectTwoObjects(send());
}

TEST_P(Cameras, WithoutStampOutliveAJumpBackInTime) {
  sendCamera(ros::Time());
  sendUntilAtOnce();
  std_msgs::Header header = nextHeader();
  header.stamp -= ros::Duration(500);
  expectTwoObjects(send(header));
  header.stamp += ros::Duration(0.1);
  expectTwoObjects(send(header));
}

TEST_P(Cameras, OfSlightlyOtherStampsAreTaken) {
  const auto sendBoth = [&] {
    const std_msgs::Header header = nextHeader();
    sendCamera(header.stamp - ros::Duration(0.03));
    return send(header);
  };
  for (int i = 0; i < 15; ++i) sendBoth();
  expectTwoObjects(sendBoth());
  // When approximate, these are pairs.
  EXPECT_EQ(log_.count(kWarning), GetParam().approximate ? 0 : 1);
  EXPECT_EQ(log_.count(" s apart"), GetParam().approximate ? 0 : 1);
}

INSTANTIATE_TEST_SUITE_P(Inputs, Cameras,
                         testing::Values(Kind{"Clouds", false, false}, Kind{"CloudsApproximate", false, true},
                                         Kind{"Depth", true, false}, Kind{"DepthApproximate", true, true}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Features, ADepthImageHasNoCameraOfAnotherFrame) {
  ros::param::set("/second/input", "depth");
  LogListener log;
  const SecondNodelet second(SecondNodelet::Names{{"depth", "/own/depth"}, {"camera_info", "/own/camera_info"}});
  ASSERT_TRUE(second.loaded());
  const ros::Publisher depths = nh_.advertise<Image>("/own/depth", 5);
  const ros::Publisher cameras = nh_.advertise<sensor_msgs::CameraInfo>("/own/camera_info", 5);
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] {
    return objects.connected() && depths.getNumSubscribers() > 0 && cameras.getNumSubscribers() > 0 && log.connected();
  }));
  sensor_msgs::CameraInfo camera = goodCamera();
  camera.header.frame_id = "another_camera";
  const char* sentence = "nor is the frame_id (some_camera/optical_frame and another_camera)";
  EXPECT_TRUE(waitUntil(
      [&] {
        cameras.publish(camera);
        depths.publish(depthImage("16UC1"));
        ros::WallDuration(0.1).sleep();
        return log.count(sentence) > 0;
      },
      20));
  const Image depth = depthImage("16UC1");
  camera.header.stamp = depth.header.stamp;
  cameras.publish(camera);
  depths.publish(depth);
  EXPECT_TRUE(objects.wait(depth.header.stamp)) << "but of the same stamp it is its partner";
}

}  // namespace

// SPDX-License-Identifier: BSD-3-Clause
// Part of the test of features.test: coordinate frames.
#include <tf2_ros/transform_broadcaster.h>

#include <map>
#include <set>

#include "features_fixture.hpp"
#include "log_listener.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

/// Nodelets that ask for tf.
class Frames : public Features {
 protected:
  void SetUp() override {
    Features::SetUp();
    ros::param::set("/second/target_frame", "base");
    ros::param::set("/second/up_frame", "base");
    ros::param::set("/second/fixed_frame", "base");
  }
  void sendPose(const std_msgs::Header& header, const Eigen::Isometry3d& T_base_camera) {
    std_msgs::Header base = header;
    base.frame_id = "base";
    broadcaster_.sendTransform(toTransformMessage(T_base_camera, base, header.frame_id));
  }
  /// Sends until the nodelet listens to tf.
  SegmentedObjectArrayConstPtr segmentIn(Listener<SegmentedObjectArray>& objects, const Eigen::Isometry3d& pose) {
    SegmentedObjectArrayConstPtr result;
    for (int i = 0; i < 20 && (!result || result->status == SegmentedObjectArray::NO_TRANSFORM); ++i) {
      const PointCloud2 cloud = goodCloud();
      sendPose(cloud.header, pose);
      result = segment(objects, cloud, goodCamera());
    }
    return result;
  }

  tf2_ros::TransformBroadcaster broadcaster_;
};

TEST_F(Frames, MissingTransformsAreSaidInTime) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return inputsConnected() && objects.connected(); }));
  const PointCloud2 cloud = goodCloud();
  const ros::WallTime start = ros::WallTime::now();
  const auto result = segment(objects, cloud, goodCamera());
  ASSERT_TRUE(result);
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 2.0);
  EXPECT_EQ(result->status, SegmentedObjectArray::NO_TRANSFORM);
  EXPECT_NE(result->message.find("base"), std::string::npos) << result->message;
  EXPECT_TRUE(result->objects.empty());
}

TEST_F(Frames, WhyATransformIsMissingIsSaidOnce) {
  ros::param::set("/second/transform_timeout", 0.3);
  LogListener log;
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return inputsConnected() && objects.connected() && log.connected(); }));
  for (int i = 0; i < 6; ++i) {
    // tf says something else of every other frame.
    PointCloud2 cloud = goodCloud();
    cloud.header.frame_id = i % 2 == 0 ? "nobody_knows" : "some_camera/optical_frame";
    if (i == 2) sendPose(nextHeader(), scene_.T_world_camera);
    const auto result = segment(objects, cloud, goodCamera());
    ASSERT_TRUE(result);
    ASSERT_EQ(result->status, SegmentedObjectArray::NO_TRANSFORM) << result->message;
    const std::size_t why = result->message.find("(~transform_timeout): ");
    ASSERT_NE(why, std::string::npos) << result->message;
    const std::string reason = result->message.substr(why + 22, 20);
    EXPECT_EQ(result->message.find(reason), result->message.rfind(reason)) << result->message;
    EXPECT_LT(result->message.size(), 400u);
  }
  EXPECT_EQ(log.count("no transform from"), 1);
}

TEST_F(Frames, UnloadsWhileItWaitsLongForATransform) {
  ros::param::set("/second/transform_timeout", 30.0);
  SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return inputsConnected() && objects.connected(); }));
  const PointCloud2 cloud = goodCloud();
  send(cloud, goodCamera());
  EXPECT_FALSE(objects.wait(cloud.header.stamp, 2.0)) << "waits";
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_TRUE(second.unload());
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 1.0);
}

TEST_F(Frames, ResultsAreMovedToTheTargetFrame) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  const auto result = segmentIn(objects, scene_.T_world_camera);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  EXPECT_EQ(result->header.frame_id, "base");
  ASSERT_EQ(result->objects.size(), 2u);
  for (const auto& object : result->objects) {
    EXPECT_EQ(object.header.frame_id, "base");
    const Eigen::Vector3d centre(object.pose.position.x, object.pose.position.y, object.pose.position.z);
    EXPECT_LT((centre - boxes_[centre.x() < 0 ? 0 : 1].centre()).norm(), 0.02) << centre.transpose();
  }
  ASSERT_EQ(result->table.values.size(), 4u);
  EXPECT_NEAR(result->table.values[2], 1, 1e-3);
  EXPECT_NEAR(result->table.values[3], 0, 5e-3);
}

TEST_F(Frames, OnlyLevelPlanesAreTables) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  auto result = segmentIn(objects, scene_.T_world_camera);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  const Eigen::Isometry3d lying(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()));
  result = segmentIn(objects, lying * scene_.T_world_camera);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::NO_TABLE) << "the table would be a wall: " << result->message;
}

TEST_F(Frames, IdentitiesAreKeptWhileTheCameraMoves) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  std::map<bool, std::set<std::uint64_t>> ids, labels;  // of the left and the right box
  for (int i = 0; i < 6; ++i) {
    const double angle = 0.25 * i;  // 16 cm a frame
    scene_.T_world_camera = lookAt({-0.65 * std::sin(angle), -0.65 * std::cos(angle), 0.65}, {0, 0, 0.03});
    frame_ = scene_.render();
    const auto result = segmentIn(objects, scene_.T_world_camera);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->objects.size(), 2u) << result->message;
    for (const auto& object : result->objects) {
      ids[object.pose.position.x < 0].insert(object.id);
      labels[object.pose.position.x < 0].insert(object.label);
    }
  }
  for (const bool left : {false, true}) {
    EXPECT_EQ(ids[left].size(), 1u);
    EXPECT_EQ(labels[left].size(), 1u);
  }
  EXPECT_NE(ids[false], ids[true]);
}

}  // namespace

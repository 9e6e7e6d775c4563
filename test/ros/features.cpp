// SPDX-License-Identifier: BSD-3-Clause
// Run by features.test beside the nodelet: outputs and the service, and in its other files inputs and frames. Limits
// are in wall time.
#include <geometry_msgs/PoseArray.h>
#include <objectness_segmentation/SegmentedTable.h>
#include <objectness_segmentation/StageTimes.h>

#include <set>

#include "features_fixture.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

TEST_F(Features, EveryOutputIsAboutTheSameFrame) {
  const std::string node = kNode;
  Listener<SegmentedObjectArray> objects(node + "/objects");
  Listener<geometry_msgs::PoseArray> poses(node + "/poses");
  Listener<SegmentedTable> table(node + "/table");
  Listener<Image> labels(node + "/label_image");
  Listener<StageTimes> profile(node + "/profile");
  Listener<PointCloud2> edges(node + "/debug/edges"), superpixels(node + "/debug/superpixels");
  Listener<visualization_msgs::MarkerArray> hidden(node + "/debug/occlusion");
  ASSERT_TRUE(waitUntil([&] {
    return poses.connected() && table.connected() && labels.connected() && profile.connected() && edges.connected() &&
           superpixels.connected() && hidden.connected();
  }));
  const PointCloud2 cloud = goodCloud();
  const auto result = segment(objects, cloud, goodCamera());
  ASSERT_TRUE(result);
  ASSERT_EQ(result->objects.size(), 2u);

  const auto image = labels.wait(cloud.header.stamp);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.frame_id, cloud.header.frame_id);
  for (const auto& object : result->objects) {
    EXPECT_GT(object.id, 0u);
    for (const int pixel : object.indices.indices) {
      EXPECT_EQ(image->data[2 * pixel] | image->data[2 * pixel + 1] << 8, static_cast<int>(object.label));
    }
  }
  const auto pose_array = poses.wait(cloud.header.stamp);
  ASSERT_TRUE(pose_array);
  ASSERT_EQ(pose_array->poses.size(), 2u);
  EXPECT_EQ(pose_array->poses[1], result->objects[1].pose);
  const auto plane = table.wait(cloud.header.stamp);
  ASSERT_TRUE(plane);
  EXPECT_TRUE(plane->found);
  EXPECT_EQ(plane->plane.values, result->table.values);
  ASSERT_GE(plane->polygon.points.size(), 4u);
  EXPECT_EQ(plane->measured.size(), plane->polygon.points.size());
  for (const auto& p : plane->polygon.points) {
    geometry_msgs::Point corner;
    corner.x = p.x, corner.y = p.y, corner.z = p.z;
    EXPECT_NEAR(toWorld(corner).z(), 0, 0.005);
  }
  const auto times = profile.wait(cloud.header.stamp);
  ASSERT_TRUE(times);
  ASSERT_EQ(times->stages.size(), times->milliseconds.size());
  const std::set<std::string> stages(times->stages.begin(), times->stages.end());
  for (const char* stage : {"conversion", "normals", "table", "surface_cues", "selection", "tracking", "total"}) {
    EXPECT_EQ(stages.count(stage), 1u) << stage;
  }
  const auto edge_cloud = edges.wait(cloud.header.stamp), superpixel_cloud = superpixels.wait(cloud.header.stamp);
  ASSERT_TRUE(edge_cloud && superpixel_cloud);
  EXPECT_GT(edge_cloud->width, 100u);
  EXPECT_GT(superpixel_cloud->width, 1000u);
  const auto voxels = hidden.wait(cloud.header.stamp);
  ASSERT_TRUE(voxels);
  ASSERT_EQ(voxels->markers.size(), 2u);
  EXPECT_GT(voxels->markers[1].points.size(), 100u);
}

TEST_F(Features, AnyOutputAloneKeepsTheInputs) {
  const auto expectInputs = [&](auto message, const char* topic) {
    {
      const Listener<decltype(message)> only(std::string(kNode) + topic);
      EXPECT_TRUE(waitUntil([&] { return inputsConnected(); })) << topic;
    }
    EXPECT_TRUE(waitUntil([&] { return inputsGone(); })) << topic;
  };
  expectInputs(geometry_msgs::PoseArray(), "/poses");
  expectInputs(SegmentedTable(), "/table");
  expectInputs(Image(), "/label_image");
  expectInputs(StageTimes(), "/profile");
  expectInputs(PointCloud2(), "/debug/edges");
  expectInputs(visualization_msgs::MarkerArray(), "/debug/occlusion");
}

TEST_F(Features, TheServiceAnswersWhenNobodySubscribes) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); })) << "subscribed for the request";
  send(goodCloud(), goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  const SegmentedObjectArray result = answer.get().result;
  EXPECT_EQ(result.status, SegmentedObjectArray::OK) << result.message;
  EXPECT_EQ(result.objects.size(), 2u);
  EXPECT_TRUE(waitUntil([&] { return inputsGone(); })) << "and not any longer";
}

TEST_F(Features, TheServiceTakesNoFrameFromBeforeTheRequest) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  send(makeCloudMessage(frame_, {}, headerNow(-1.0)), goodCamera());
  EXPECT_FALSE(waitUntil([&] { return isReady(answer); }, 1.5));
  const PointCloud2 fresh = makeCloudMessage(frame_, {}, headerNow());
  send(fresh, goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  EXPECT_EQ(answer.get().result.header.stamp, fresh.header.stamp);
}

TEST_F(Features, TheServiceSaysHowFarTheClocksDiffer) {
  auto answer = request(kNode, 2);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  while (!isReady(answer)) {
    send(makeCloudMessage(frame_, {}, headerNow(-6.5)), goodCamera());
    waitUntil([&] { return isReady(answer); }, 0.2);
  }
  const SegmentedObjectArray result = answer.get().result;
  EXPECT_EQ(result.status, SegmentedObjectArray::NO_INPUT);
  for (const char* part : {"stamps are 6.5 s behind this clock", "NTP"}) {
    EXPECT_NE(result.message.find(part), std::string::npos) << result.message;
  }
}

TEST_F(Features, TheServiceSaysWhatIsMissing) {
  auto answer = request(kNode, 0.5);
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }, 10));
  const SegmentedObjectArray result = answer.get().result;
  EXPECT_EQ(result.status, SegmentedObjectArray::NO_INPUT);
  EXPECT_NE(result.message.find("no messages on " + points()), std::string::npos) << result.message;
}

TEST_F(Features, AFrameThatCannotBeSegmentedAnswersTheService) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  PointCloud2 cloud = goodCloud();
  cloud.data.resize(10);
  send(cloud, goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  EXPECT_EQ(answer.get().result.status, SegmentedObjectArray::BAD_INPUT);
}

TEST_F(Features, UnloadsWhileTheServiceWaits) {
  SecondNodelet second(SecondNodelet::Names{{"points", "/nowhere"}, {"camera_info", "/nowhere_info"}});
  ASSERT_TRUE(second.loaded());
  ASSERT_TRUE(ros::service::waitForService("/second/segment", kTimeout * 1000));
  auto answer = request("/second", 60);
  ros::WallDuration(0.5).sleep();
  EXPECT_FALSE(isReady(answer));
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_TRUE(second.unload());
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 1.0);
  EXPECT_TRUE(waitUntil([&] { return isReady(answer); }, 5));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "features_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}

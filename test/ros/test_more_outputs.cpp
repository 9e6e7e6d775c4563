// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>

#include "fixtures/ray_cast.hpp"
#include "integral/cue_volumes.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/debug_conversions.hpp"
#include "two_objects.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using visualization_msgs::Marker;

TEST(Poses, AreThoseOfTheObjects) {
  const SegmentedFrame result = makeResult();
  const auto objects = toObjectsMessage(result, makeHeader()).objects;
  const geometry_msgs::PoseArray poses = toPoses(result, makeHeader());
  ASSERT_EQ(poses.poses.size(), objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) EXPECT_EQ(poses.poses[i], objects[i].pose);
}

TEST(TableMessage, LiesOnThePlane) {
  const SegmentedFrame result = makeResult();
  const SegmentedTable message = toTableMessage(result, makeHeader());
  EXPECT_TRUE(message.found);
  EXPECT_EQ(message.plane.values, (std::vector<float>{0, 0, -1, 1}));
  ASSERT_EQ(message.polygon.points.size(), 4u);
  double doubled_area = 0;  // seen from above, where y is turned round
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &p = message.polygon.points[i], &q = message.polygon.points[(i + 1) % 4];
    EXPECT_NEAR(p.z, 1, 1e-6);
    doubled_area += p.x * -q.y - q.x * -p.y;
  }
  EXPECT_NEAR(doubled_area, 2 * 1.0 * 0.8, 1e-6);
  EXPECT_EQ(message.measured, (std::vector<std::uint8_t>{1, 0, 1, 1}));
  EXPECT_NEAR(message.pose.position.z, 1, 1e-9);
}

TEST(LabelImage, HasTheLabelsOfTheObjects) {
  SegmentedFrame result = makeResult();
  result.segmentation.labels = cv::Mat_<ushort>(3, 4, ushort{1});
  result.identities.resize(2);
  result.identities[0].label = 9;
  result.identities[1].label = 2;
  const sensor_msgs::Image image = toLabelImage(result, makeHeader());
  EXPECT_EQ(image.header, makeHeader());
  EXPECT_EQ(image.encoding, "16UC1");
  ASSERT_EQ(image.width, 4u);
  ASSERT_EQ(image.height, 3u);
  for (int i = 0; i < 12; ++i) {
    const int label = image.data[2 * i] | image.data[2 * i + 1] << 8;
    EXPECT_EQ(label, i == 0 || i == 2 || i == 3 ? 9 : i == 9 ? 2 : 1) << i;
  }
}

TEST(MoveToFrame, MovesPointsBoxesAndTableAlike) {
  const SegmentedFrame before = makeResult();
  SegmentedFrame after = before;
  Eigen::Isometry3d T =
      Eigen::Translation3d(1, 2, 3) * Eigen::Isometry3d(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  moveToFrame(after, T);
  for (const int i : {0, 2, 11}) {
    EXPECT_TRUE(after.frame.points[i].isApprox(T.cast<float>() * before.frame.points[i], 1e-5F));
    EXPECT_NEAR(after.segmentation.table.height(after.frame.points[i]),
                before.segmentation.table.height(before.frame.points[i]), 1e-5);
    const Eigen::Vector3d moved = after.segmentation.table.T_table_camera * after.frame.points[i].cast<double>();
    const Eigen::Vector3d in_place = before.segmentation.table.T_table_camera * before.frame.points[i].cast<double>();
    EXPECT_LT((moved - in_place).norm(), 1e-5);
  }
  EXPECT_TRUE(std::isnan(after.frame.points[1].x()));
  const auto& box = after.segmentation.segments[1].box;
  EXPECT_TRUE(box.T_camera_box.isApprox(T * before.segmentation.segments[1].box.T_camera_box, 1e-12));
  // Messages of it lie on the moved plane, too.
  const SegmentedTable table = toTableMessage(after, makeHeader());
  for (const auto& p : table.polygon.points) {
    EXPECT_NEAR(after.segmentation.table.height({p.x, p.y, p.z}), 0, 1e-5);
  }
}

TEST(DebugClouds, HoldTheMarkedPixels) {
  SegmentedFrame result = makeResult();
  result.segmentation.edges.kinds = cv::Mat_<uchar>(3, 4, uchar{0});
  result.segmentation.edges.kinds(0, 0) = objectness::kHighCurvature;
  result.segmentation.edges.kinds(0, 1) = objectness::kBorder;  // an invalid point
  result.segmentation.edges.kinds(2, 3) = objectness::kOccluded;
  const sensor_msgs::PointCloud2 edges = toEdgesCloud(result, makeHeader());
  ASSERT_EQ(edges.width, 2u);
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> kind(edges, "label");
  EXPECT_EQ(*kind, static_cast<std::uint32_t>(objectness::kHighCurvature));
  ++kind;
  EXPECT_EQ(*kind, static_cast<std::uint32_t>(objectness::kOccluded));

  result.segmentation.superpixels.label = cv::Mat_<int>(3, 4, 0);
  result.segmentation.superpixels.label(1, 1) = 70000;
  const sensor_msgs::PointCloud2 superpixels = toSuperpixelsCloud(result, makeHeader());
  ASSERT_EQ(superpixels.width, 1u);
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(superpixels, "label");
  EXPECT_EQ(*label, 70000u);
}

TEST(HiddenVoxels, LieBehindWhatIsSeen) {
  Scene scene;
  scene.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  scene.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0), box({-0.1, -0.05, 0}, {0.1, 0.05, 0.12})};
  SegmentedFrame result;
  result.frame = scene.render();
  const objectness::Config config;
  result.segmentation = objectness::segment(result.frame, config);
  ASSERT_TRUE(result.segmentation.status.ok()) << result.segmentation.status.message;
  const std::vector<Eigen::Vector3d> voxels = hiddenVoxels(result, config);
  ASSERT_GT(voxels.size(), 100u);
  const Eigen::Isometry3d T_camera_table = result.segmentation.table.T_table_camera.inverse();
  int within_or_behind = 0;
  for (const Eigen::Vector3d& voxel : voxels) {
    EXPECT_TRUE(isOccluded(result.frame, T_camera_table * voxel, config.volume));
    within_or_behind += (scene.T_world_camera * (T_camera_table * voxel)).y() > -0.06;
  }
  EXPECT_EQ(within_or_behind, static_cast<int>(voxels.size()));
  const auto markers = toHiddenMarkers(result, voxels, config.volume.voxel_m, makeHeader());
  ASSERT_EQ(markers.markers.size(), 2u);
  EXPECT_EQ(markers.markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(markers.markers[1].type, Marker::CUBE_LIST);
  EXPECT_EQ(markers.markers[1].points.size(), voxels.size());
}

}  // namespace

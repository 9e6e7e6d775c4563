// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <set>
#include <tuple>

#include "common/color_palette.hpp"
#include "fixtures/ros_messages.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/debug_conversions.hpp"
#include "two_objects.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using visualization_msgs::Marker;

TEST(ObjectsMessage, HoldsWhatTheSegmentationHolds) {
  const SegmentedFrame result = makeResult();
  const objectness::Segmentation& segmentation = result.segmentation;
  const std_msgs::Header header = makeHeader();
  const SegmentedObjectArray message = toObjectsMessage(result, header);
  EXPECT_EQ(message.header, header);
  EXPECT_EQ(message.status, SegmentedObjectArray::OK);
  EXPECT_TRUE(message.message.empty());
  EXPECT_EQ(message.table.header, header);
  EXPECT_EQ(message.table.values, (std::vector<float>{0, 0, -1, 1}));
  EXPECT_EQ(message.boxes_sampled, 5000000000u);
  EXPECT_EQ(message.boxes_scored, 20u);
  EXPECT_EQ(message.boxes_passed, 3u);
  ASSERT_EQ(message.objects.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const SegmentedObject& object = message.objects[i];
    const objectness::Segment& segment = segmentation.segments[i];
    EXPECT_EQ(object.header, header);
    EXPECT_EQ(object.indices.header, header);
    EXPECT_EQ(object.cloud.header, header);
    EXPECT_EQ(object.label, 2 + i);
    EXPECT_EQ(object.indices.indices, segment.pixels);
    EXPECT_EQ(object.pose.position.x, segment.box.T_camera_box.translation().x());
    EXPECT_EQ(object.dimensions.z, segment.box.size_m.z());
    const auto& q = object.pose.orientation;
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    EXPECT_TRUE(rotation.isApprox(segment.box.T_camera_box.linear(), 1e-9));
    EXPECT_FLOAT_EQ(object.objectness, static_cast<float>(segment.objectness));
    EXPECT_FLOAT_EQ(object.edge_density, 0.25F);
    EXPECT_FLOAT_EQ(object.outer_edges, 0.5F);
    EXPECT_FLOAT_EQ(object.straddling, 0.75F);
    EXPECT_FLOAT_EQ(object.free_space, 2.0F);
  }
}

TEST(ObjectsMessage, TellsWhatStandsOnWhat) {
  SegmentedFrame result = makeResult();
  std::vector<objectness::Segment>& segments = result.segmentation.segments;
  segments[0].support = {objectness::SupportKind::kSegment, 1, 0.125};
  segments[0].round = true;
  segments[0].visible_box.size_m = {0.1, 0.2, 0.3};
  segments[0].visible_box.T_camera_box.translation() << 1, 2, 3;
  segments[1].carried = {0};
  result.identities.resize(2);
  result.identities[0].label = 7;
  result.identities[1].label = 5;
  SegmentedObjectArray message = toObjectsMessage(result, makeHeader());
  EXPECT_EQ(message.objects[0].supported_by, 5u);
  EXPECT_EQ(message.objects[0].base_height, 0.125F);
  EXPECT_TRUE(message.objects[0].round);
  EXPECT_TRUE(message.objects[0].supports.empty());
  EXPECT_EQ(message.objects[0].visible_dimensions.y, 0.2);
  EXPECT_EQ(message.objects[0].visible_pose.position.z, 3);
  EXPECT_EQ(message.objects[1].supported_by, SegmentedObject::LABEL_TABLE);
  EXPECT_FALSE(message.objects[1].round);
  EXPECT_EQ(message.objects[1].supports, (std::vector<std::uint32_t>{7}));
  segments[0].support = {objectness::SupportKind::kOther, -1, 0.1};
  message = toObjectsMessage(result, makeHeader());
  EXPECT_EQ(message.objects[0].supported_by, SegmentedObject::LABEL_NOTHING);
}

TEST(ObjectsMessage, CountsNoBoxesWhereNoneWereSampled) {
  SegmentedFrame result = makeResult();
  result.segmentation.report = {};
  result.segmentation.report.hypotheses = 7;
  const SegmentedObjectArray message = toObjectsMessage(result, makeHeader());
  EXPECT_EQ(message.boxes_sampled + message.boxes_scored + message.boxes_passed, 0u);
}

TEST(ObjectsMessage, CloudsHoldTheFramesPoints) {
  const objectness::Frame frame = makeSmallFrame();
  SegmentedObjectArray message = toObjectsMessage(makeResult(frame), makeHeader());
  sensor_msgs::PointCloud2& cloud = message.objects[0].cloud;
  ASSERT_EQ(cloud.width * cloud.height, 3u);
  EXPECT_EQ(cloud.data.size(), cloud.row_step * cloud.height);
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), z(cloud, "z");
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> b(cloud, "b"), r(cloud, "r");
  for (const int pixel : {0, 2, 3}) {
    EXPECT_EQ(*x, frame.points[pixel].x());
    EXPECT_EQ(*z, frame.points[pixel].z());
    EXPECT_EQ(*b, frame.color(0, pixel)[0]);
    EXPECT_EQ(*r, frame.color(0, pixel)[2]);
    ++x, ++z, ++b, ++r;
  }

  objectness::Frame grey = frame;
  grey.color.release();
  message = toObjectsMessage(makeResult(grey), makeHeader());
  EXPECT_EQ(message.objects[0].cloud.fields.size(), 3u);
  EXPECT_EQ(message.objects[0].cloud.data.size(), 3u * 12u);
}

TEST(SegmentsCloud, HasLabelsAndColoursByRank) {
  const objectness::Frame frame = makeSmallFrame();
  const std_msgs::Header header = makeHeader();
  const sensor_msgs::PointCloud2 cloud = toSegmentsCloud(makeResult(frame), header);
  EXPECT_EQ(cloud.header, header);
  ASSERT_EQ(cloud.width * cloud.height, 4u);
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
  sensor_msgs::PointCloud2ConstIterator<float> y(cloud, "y");
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> b(cloud, "b"), g(cloud, "g"), r(cloud, "r");
  for (const auto& [pixel, rank] : std::vector<std::pair<int, int>>{{0, 0}, {2, 0}, {3, 0}, {9, 1}}) {
    EXPECT_EQ(*label, static_cast<std::uint32_t>(2 + rank));
    EXPECT_EQ(*y, frame.points[pixel].y());
    const objectness::Rgb color = objectness::objectColor(static_cast<std::size_t>(rank));
    EXPECT_EQ(std::make_tuple(*r, *g, *b), std::make_tuple(color.r, color.g, color.b));
    ++label, ++y, ++b, ++g, ++r;
  }
}

TEST(Markers, DeleteEverythingFirst) {
  const std_msgs::Header header = makeHeader();
  const visualization_msgs::MarkerArray array = toMarkers(makeResult(), header);
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
  std::set<std::pair<std::string, int>> ids;
  for (const Marker& marker : array.markers) {
    EXPECT_EQ(marker.header, header);
    EXPECT_TRUE(ids.emplace(marker.ns, marker.id).second) << marker.ns << marker.id;
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-9);
    if (&marker != &array.markers[0]) {
      EXPECT_EQ(marker.action, Marker::ADD);
      EXPECT_EQ(marker.color.a, 1.0F);
    }
  }
  for (const char* ns : {"boxes", "labels", "table"}) EXPECT_EQ(ids.count({ns, 0}) + ids.count({ns, 1}), 2u) << ns;
}

TEST(Markers, BoxHasTwelveEdgesOfItsSize) {
  const visualization_msgs::MarkerArray array = toMarkers(makeResult(), makeHeader());
  const Marker& box = array.markers[1];
  ASSERT_EQ(box.type, Marker::LINE_LIST);
  ASSERT_EQ(box.points.size(), 24u);
  double length = 0;
  for (std::size_t i = 0; i < box.points.size(); i += 2) {
    const auto &a = box.points[i], &b = box.points[i + 1];
    length += std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
    EXPECT_NEAR(std::abs(a.x), 0.05, 1e-12);
    EXPECT_NEAR(std::abs(b.y), 0.1, 1e-12);
    EXPECT_NEAR(std::abs(b.z), 0.025, 1e-12);
  }
  EXPECT_NEAR(length, 4 * (0.1 + 0.2 + 0.05), 1e-9);
}

TEST(Markers, TableLiesOnThePlane) {
  const SegmentedFrame result = makeResult();
  const objectness::Segmentation& segmentation = result.segmentation;
  const visualization_msgs::MarkerArray array = toMarkers(result, makeHeader());
  const Marker& outline = array.markers[array.markers.size() - 2];
  const Marker& normal = array.markers.back();
  ASSERT_EQ(outline.type, Marker::LINE_STRIP);
  ASSERT_EQ(outline.points.size(), 5u);
  EXPECT_EQ(outline.points.front(), outline.points.back());
  const auto toCamera = [](const Marker& marker, const geometry_msgs::Point& p) {
    const auto& q = marker.pose.orientation;
    const auto& t = marker.pose.position;
    return Eigen::Vector3d(Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d(p.x, p.y, p.z) +
                           Eigen::Vector3d(t.x, t.y, t.z));
  };
  for (const auto& point : outline.points) {
    EXPECT_NEAR(segmentation.table.height(toCamera(outline, point).cast<float>()), 0, 1e-6);
  }
  ASSERT_EQ(normal.points.size(), 2u);
  const Eigen::Vector3d arrow = toCamera(normal, normal.points[1]) - toCamera(normal, normal.points[0]);
  EXPECT_TRUE(arrow.normalized().isApprox(segmentation.table.normal, 1e-9));
}

TEST(Outputs, OfAFailureSayWhyAndNothingElse) {
  SegmentedFrame failed;
  failed.segmentation = makeSegmentation();
  failed.segmentation.table = {};
  failed.segmentation.status = objectness::Status::error(objectness::StatusCode::kNoTable, "no plane");
  const std_msgs::Header header = makeHeader();
  const SegmentedObjectArray message = toObjectsMessage(failed, header);
  EXPECT_EQ(message.header, header);
  EXPECT_EQ(message.status, SegmentedObjectArray::NO_TABLE);
  EXPECT_EQ(message.message, "no plane");
  EXPECT_TRUE(message.objects.empty());
  EXPECT_TRUE(message.table.values.empty());
  const sensor_msgs::PointCloud2 cloud = toSegmentsCloud(failed, header);
  EXPECT_EQ(cloud.header, header);
  EXPECT_EQ(cloud.width, 0u);
  EXPECT_EQ(cloud.fields.size(), 5u);
  const visualization_msgs::MarkerArray markers = toMarkers(failed, header);
  ASSERT_EQ(markers.markers.size(), 1u);
  EXPECT_EQ(markers.markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(toPoses(failed, header).header, header);
  EXPECT_TRUE(toPoses(failed, header).poses.empty());
  EXPECT_FALSE(toTableMessage(failed, header).found);
  EXPECT_TRUE(toTableMessage(failed, header).polygon.points.empty());
  EXPECT_EQ(toLabelImage(failed, header).width, 0u);
  EXPECT_EQ(toEdgesCloud(failed, header).width, 0u);
  EXPECT_EQ(toSuperpixelsCloud(failed, header).width, 0u);
  EXPECT_TRUE(hiddenVoxels(failed, objectness::Config{}).empty());
  EXPECT_EQ(toHiddenMarkers(failed, {}, 0.01, header).markers.size(), 1u);
}

TEST(Outputs, CarryTheIdentityWhereThereIsOne) {
  SegmentedFrame result = makeResult();
  result.identities.resize(2);
  result.identities[0] = {7, 42, 3, 0.5, 0.75};
  result.identities[1] = {2, 5, 1, 0, 0.3};
  const SegmentedObjectArray message = toObjectsMessage(result, makeHeader());
  EXPECT_EQ(message.objects[0].label, 7u);
  EXPECT_EQ(message.objects[0].id, 42u);
  EXPECT_EQ(message.objects[0].age_frames, 3u);
  EXPECT_FLOAT_EQ(message.objects[0].age, 0.5F);
  EXPECT_FLOAT_EQ(message.objects[0].confidence, 0.75F);
  EXPECT_EQ(message.objects[1].label, 2u);

  const sensor_msgs::PointCloud2 cloud = toSegmentsCloud(result, makeHeader());
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> r(cloud, "r");
  EXPECT_EQ(*label, 7u);
  EXPECT_EQ(*r, objectness::objectColor(5).r);

  const visualization_msgs::MarkerArray markers = toMarkers(result, makeHeader());
  EXPECT_EQ(markers.markers[1].id, 5);
  EXPECT_NE(markers.markers[2].text.find("#42"), std::string::npos);
}

TEST(ColorPalette, HasTwentyDistinctColours) {
  std::set<std::tuple<int, int, int>> colors;
  for (std::size_t rank = 0; rank < 20; ++rank) {
    const objectness::Rgb color = objectness::objectColor(rank);
    colors.emplace(color.r, color.g, color.b);
  }
  EXPECT_EQ(colors.size(), 20u);
  EXPECT_EQ(objectness::objectColor(23).r, objectness::objectColor(3).r);
}

}  // namespace

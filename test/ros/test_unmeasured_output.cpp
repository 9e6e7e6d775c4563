// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "fixtures/thing_without_depth.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "two_objects.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using visualization_msgs::Marker;

/// Two things without depth on the table, the second with a box.
SegmentedFrame withUnmeasured() {
  SegmentedFrame result = makeResult();
  objectness::Unmeasured thing = thingWithoutDepth();
  result.segmentation.unmeasured.push_back(thing);
  thing.box = result.segmentation.segments[1].box;
  result.segmentation.unmeasured.push_back(thing);
  return result;
}

std::vector<Marker> markersOf(const SegmentedFrame& result) {
  std::vector<Marker> markers;
  for (const Marker& marker : toMarkers(result, makeHeader()).markers) {
    if (marker.ns == "unmeasured") markers.push_back(marker);
  }
  return markers;
}

}  // namespace

TEST(UnmeasuredMessage, HoldsEverythingAndIsNoObject) {
  const SegmentedFrame result = withUnmeasured();
  const SegmentedObjectArray message = toObjectsMessage(result, makeHeader());
  EXPECT_EQ(message.objects.size(), 2u);
  ASSERT_EQ(message.unmeasured.size(), 2u);
  const Unmeasured &flat = message.unmeasured[0], &tall = message.unmeasured[1];
  ASSERT_EQ(flat.outline.points.size(), 3u);
  EXPECT_EQ(flat.outline.points[1].x, 0.25f);
  EXPECT_EQ(flat.outline.points[0].y, 0.5f);
  EXPECT_EQ(flat.outline.points[2].z, 1.5f);
  EXPECT_EQ(flat.pixels, 1234u);
  EXPECT_EQ(flat.area, 0.0625f);
  EXPECT_EQ(flat.table_share, 0.75f);
  EXPECT_EQ(flat.noise_ratio, 4.5f);
  EXPECT_FALSE(flat.has_box);
  EXPECT_EQ(flat.pose.orientation.w, 1);
  EXPECT_EQ(flat.dimensions.x, 0);
  EXPECT_TRUE(tall.has_box);
  EXPECT_EQ(tall.pose, message.objects[1].pose);
  EXPECT_EQ(tall.dimensions, message.objects[1].dimensions);
}

TEST(UnmeasuredMarkers, AreOutlinesAndBoxesOfTheirOwn) {
  const std::vector<Marker> markers = markersOf(withUnmeasured());
  ASSERT_EQ(markers.size(), 3u);
  EXPECT_EQ(markers[0].type, Marker::LINE_STRIP);
  EXPECT_EQ(markers[0].points.size(), 4u);
  EXPECT_EQ(markers[0].points.front(), markers[0].points.back());
  EXPECT_EQ(markers[1].type, Marker::LINE_STRIP);
  EXPECT_EQ(markers[2].type, Marker::LINE_LIST);
  EXPECT_EQ(markers[2].points.size(), 24u);
  EXPECT_EQ(std::set<int>({markers[0].id, markers[1].id, markers[2].id}).size(), 3u);
}

TEST(Unmeasured, MovesWithTheOthersToAnotherFrame) {
  const SegmentedFrame before = withUnmeasured();
  SegmentedFrame after = before;
  const Eigen::Isometry3d T = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  moveToFrame(after, T);
  for (std::size_t k = 0; k < 2; ++k) {
    const objectness::Unmeasured &from = before.segmentation.unmeasured[k], &to = after.segmentation.unmeasured[k];
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(to.outline[i].isApprox(T * from.outline[i], 1e-12));
  }
  EXPECT_TRUE(after.segmentation.unmeasured[1].box->T_camera_box.isApprox(
      T * before.segmentation.unmeasured[1].box->T_camera_box, 1e-12));
}

TEST(Unmeasured, IsNotToldOfAFailedFrame) {
  SegmentedFrame failed = withUnmeasured();
  failed.segmentation.status = objectness::Status::error(objectness::StatusCode::kCancelled, "cancelled");
  EXPECT_TRUE(toObjectsMessage(failed, makeHeader()).unmeasured.empty());
  EXPECT_TRUE(markersOf(failed).empty());
}

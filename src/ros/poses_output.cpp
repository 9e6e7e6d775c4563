// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/geometry_output.hpp"
#include "ros/table_output.hpp"

namespace objectness_segmentation {

geometry_msgs::PoseArray toPoses(const SegmentedFrame& result, const std_msgs::Header& header) {
  geometry_msgs::PoseArray message;
  message.header = header;
  if (!result.segmentation.status.ok()) return message;
  for (const objectness::Segment& segment : result.segmentation.segments) {
    message.poses.push_back(toPose(segment.box.T_camera_box));
  }
  return message;
}

namespace {

void move(objectness::Plane& plane, const Eigen::Isometry3d& T_target_camera) {
  plane.normal = T_target_camera.linear() * plane.normal;
  plane.d -= plane.normal.dot(T_target_camera.translation());
}

}  // namespace

void moveToFrame(SegmentedFrame& result, const Eigen::Isometry3d& T_target_camera) {
  const Eigen::Isometry3f T = T_target_camera.cast<float>();
  for (Eigen::Vector3f& p : result.frame.points) p = T * p;
  objectness::Table& table = result.segmentation.table;
  if (hasTable(table)) move(table, T_target_camera);
  for (objectness::Plane& plane : table.other_planes) move(plane, T_target_camera);
  table.T_table_camera = table.T_table_camera * T_target_camera.inverse();
  for (objectness::Segment& segment : result.segmentation.segments) {
    segment.box.T_camera_box = T_target_camera * segment.box.T_camera_box;
    segment.visible_box.T_camera_box = T_target_camera * segment.visible_box.T_camera_box;
  }
  for (objectness::Unmeasured& thing : result.segmentation.unmeasured) {
    for (Eigen::Vector3d& corner : thing.outline) corner = T_target_camera * corner;
    if (thing.box) thing.box->T_camera_box = T_target_camera * thing.box->T_camera_box;
  }
  for (objectness::RankedBox& proposal : result.segmentation.proposals) {
    proposal.box.T_camera_box = T_target_camera * proposal.box.T_camera_box;
  }
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#include "ros/table_output.hpp"

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/geometry_output.hpp"

namespace objectness_segmentation {

std::vector<float> planeCoefficients(const objectness::Table& table) {
  if (!hasTable(table)) return {};
  const Eigen::Vector3f normal = table.normal.cast<float>();
  return {normal.x(), normal.y(), normal.z(), static_cast<float>(table.d)};
}

SegmentedTable toTableMessage(const SegmentedFrame& result, const std_msgs::Header& header) {
  const objectness::Table& table = result.segmentation.table;
  SegmentedTable message;
  message.header = message.plane.header = header;
  message.pose.orientation.w = 1;
  message.found = hasTable(table);
  if (!message.found) return message;
  message.plane.values = planeCoefficients(table);
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  message.pose = toPose(T_camera_table);
  for (const Eigen::Vector2d& corner : table.hull) {
    message.polygon.points.push_back(toPoint32(T_camera_table * Eigen::Vector3d(corner.x(), corner.y(), 0)));
  }
  for (const char side : table.hull_measured) message.measured.push_back(side != 0);
  return message;
}

}  // namespace objectness_segmentation

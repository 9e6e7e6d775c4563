// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fixtures/ros_messages.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_test {

/// Two objects on a table one metre below a camera that looks straight down.
inline objectness::Segmentation makeSegmentation() {
  objectness::Segmentation result;
  result.table.normal = {0, 0, -1};
  result.table.d = 1;
  result.table.T_table_camera.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  result.table.T_table_camera.translation().z() = 1;
  result.table.hull = {{-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {-0.5, 0.4}};
  result.table.hull_measured = {1, 0, 1, 1};
  for (int i = 0; i < 2; ++i) {
    objectness::Segment segment;
    segment.box.T_camera_box.translation() = Eigen::Vector3d(0.1 + i, 0.2, 0.9);
    segment.box.T_camera_box.linear() =
        result.table.T_table_camera.linear() * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    segment.box.size_m = {0.1, 0.2, 0.05 + 0.1 * i};
    segment.objectness = 1.5 - i;
    segment.cues = {0.25, 0.5, 0.75, 2.0};
    result.segments.push_back(segment);
  }
  result.segments[0].pixels = {0, 2, 3};
  result.segments[1].pixels = {9};
  result.report.boxes_sampled = 5000000000;
  result.report.boxes_scored = 20;
  result.report.boxes_passed = 3;
  return result;
}

inline objectness_segmentation::SegmentedFrame makeResult(const objectness::Frame& frame = makeSmallFrame()) {
  objectness_segmentation::SegmentedFrame result;
  result.frame = frame;
  result.segmentation = makeSegmentation();
  return result;
}

}  // namespace objectness_test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <objectness_segmentation/SegmentedTable.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// A result as messages, each with the given header (REP 103, metres): that of the input, or of another frame that the
/// result was moved to. When the status is not ok, each says so: no objects and the reason, an empty cloud, nothing but
/// DELETEALL. Labels and colours are those of result.identities, where there are any, or go by rank.

/// processing_time and dropped_frames are left to the caller.
SegmentedObjectArray toObjectsMessage(const SegmentedFrame& result, const std_msgs::Header& header);

/// The points of all segments, in one list: x y z, rgb (objectColor() of the label) and label as in SegmentedObject.
sensor_msgs::PointCloud2 toSegmentsCloud(const SegmentedFrame& result, const std_msgs::Header& header);

/// DELETEALL first; then per object a box (namespace "boxes", id = label - LABEL_FIRST_OBJECT) and its label, identity
/// and objectness ("labels"), outlines and boxes of things without depth ("unmeasured"), and the outline and normal of
/// the table ("table").
visualization_msgs::MarkerArray toMarkers(const SegmentedFrame& result, const std_msgs::Header& header);

/// Centres and axes of the boxes, in the order of the objects.
geometry_msgs::PoseArray toPoses(const SegmentedFrame& result, const std_msgs::Header& header);

SegmentedTable toTableMessage(const SegmentedFrame& result, const std_msgs::Header& header);

/// 16UC1, size of the input: 0 nothing, 1 table, else the label of the object. Of a failed frame of unknown size: 0 x
/// 0.
sensor_msgs::Image toLabelImage(const SegmentedFrame& result, const std_msgs::Header& header);

/// The identity of segment number `rank`.
objectness::Identity identityOf(const SegmentedFrame& result, std::size_t rank);

/// Moves everything that is measured in metres (points, boxes, planes) to another coordinate frame. Pixels stay, and
/// the camera is no longer that of the points.
void moveToFrame(SegmentedFrame& result, const Eigen::Isometry3d& T_target_camera);

}  // namespace objectness_segmentation

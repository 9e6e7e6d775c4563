// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/SegmentedObjectArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_segmentation {

/// A result as messages, each with the header of the input (REP 103 optical frame, metres). When the status is not ok,
/// each says so: no objects and the reason, an empty cloud, nothing but DELETEALL.

/// processing_time and dropped_frames are left to the caller.
SegmentedObjectArray toObjectsMessage(const objectness::Segmentation& segmentation, const objectness::Frame& frame,
                                      const std_msgs::Header& header);

/// The points of all segments, in one list: x y z, rgb (objectColor() of the rank) and label as in SegmentedObject.
sensor_msgs::PointCloud2 toSegmentsCloud(const objectness::Segmentation& segmentation, const objectness::Frame& frame,
                                         const std_msgs::Header& header);

/// DELETEALL first; then per object a box (namespace "boxes", id = rank) and its objectness ("labels"), and the outline
/// and normal of the table ("table").
visualization_msgs::MarkerArray toMarkers(const objectness::Segmentation& segmentation, const std_msgs::Header& header);

}  // namespace objectness_segmentation

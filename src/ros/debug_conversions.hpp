// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <vector>

#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// What the method sees, for ~debug/*: made only when somebody subscribes.

/// The edge points: x y z, rgb (white: crease, yellow: near side of a depth jump, blue: its far side, red: beside
/// missing depth) and label, the EdgeKind bits.
sensor_msgs::PointCloud2 toEdgesCloud(const SegmentedFrame& result, const std_msgs::Header& header);

/// The points in superpixels: x y z, rgb and label, the superpixel's number.
sensor_msgs::PointCloud2 toSuperpixelsCloud(const SegmentedFrame& result, const std_msgs::Header& header);

/// Centres of the voxels over the table that are hidden from the camera (paper Sec. 2.3), in the table frame. Before
/// the result is moved to another frame: it takes the camera's view.
std::vector<Eigen::Vector3d> hiddenVoxels(const SegmentedFrame& result, const objectness::Config& config);

/// These voxels as cubes (namespace "occlusion"), after a DELETEALL.
visualization_msgs::MarkerArray toHiddenMarkers(const SegmentedFrame& result,
                                                const std::vector<Eigen::Vector3d>& voxels, double voxel_m,
                                                const std_msgs::Header& header);

}  // namespace objectness_segmentation

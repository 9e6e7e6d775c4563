// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_segmentation {

/// A list of so many points, zeroed: x y z, then "rgb" (packed, FLOAT32 as PCL and rviz expect it) and "label" (UINT32)
/// when asked for, without padding.
sensor_msgs::PointCloud2 makeCloud(const std_msgs::Header& header, std::size_t size, bool with_color, bool with_label);

/// Writes x y z, and a colour behind it when given (B, G, R).
void writePoint(std::uint8_t* destination, const Eigen::Vector3f& point, const cv::Vec3b* bgr);

/// Writes the label of a cloud that has colour, too.
void writeLabel(std::uint8_t* destination, std::uint32_t label);

/// The frame's points with these pixel indices, with the frame's colours when it has any.
sensor_msgs::PointCloud2 extractCloud(const objectness::Frame& frame, const std::vector<int>& pixels,
                                      const std_msgs::Header& header);

}  // namespace objectness_segmentation

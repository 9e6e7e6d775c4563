// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_segmentation {

/// The frame as a camera driver sends it: organized, x y z and, when it has colours, rgb.
sensor_msgs::PointCloud2 toCloudMessage(const objectness::Frame& frame, const std_msgs::Header& header);

/// The camera of a rectified image.
sensor_msgs::CameraInfo toCameraInfo(const objectness::PinholeCamera& camera, const std_msgs::Header& header);

}  // namespace objectness_segmentation

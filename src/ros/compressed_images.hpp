// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include "objectness_segmentation/common/status.hpp"

namespace objectness_segmentation {

/// Whether it is a depth image of compressed_depth_image_transport.
bool isCompressedDepth(const sensor_msgs::CompressedImage& message);

/// The depth image (16UC1 or 32FC1) of a compressedDepth topic. 32FC1 is stored as 16-bit inverse depth v, and read as
/// a / (v - b), the a and b of the message; v = 0 is a pixel without depth (NaN). kBadInput: cut off, no PNG, or of
/// another format (RVL).
objectness::Result<sensor_msgs::ImageConstPtr> decodeDepth(const sensor_msgs::CompressedImage& message);

/// The picture (bgr8) of a compressed topic: JPEG or PNG. kBadInput: neither.
objectness::Result<sensor_msgs::ImageConstPtr> decodeColor(const sensor_msgs::CompressedImage& message);

}  // namespace objectness_segmentation

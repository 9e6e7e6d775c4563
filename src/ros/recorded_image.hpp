// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ros/compressed_images.hpp"
#include "ros/read_message.hpp"

namespace objectness_segmentation {

/// An image of a recording, decoded where it is compressed. Throws what readMessage() throws, and
/// rosbag::BagFormatException for one that cannot be decoded.
inline sensor_msgs::ImageConstPtr readImage(const rosbag::MessageInstance& entry) {
  if (!entry.isType<sensor_msgs::CompressedImage>()) return readMessage<sensor_msgs::Image>(entry);
  const auto message = readMessage<sensor_msgs::CompressedImage>(entry);
  const auto image = isCompressedDepth(*message) ? decodeDepth(*message) : decodeColor(*message);
  if (!image.ok()) throw rosbag::BagFormatException(entry.getTopic() + " " + image.status.message);
  return image.value;
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness_segmentation {

/// The topics of one depth camera. In the place of clouds there may be depth images, and pictures beside them.
struct InputTopics {
  std::string points, camera_info;
  std::string depth, color;

  bool ofDepth() const { return !depth.empty(); }
  /// Of the clouds or depth images.
  const std::string& first() const { return ofDepth() ? depth : points; }
};

/// Topics of a bag that hold what the nodelet takes. Those that are left empty in `wanted` are chosen:
/// - organized clouds (sensor_msgs/PointCloud2), else depth images (sensor_msgs/Image of 16UC1 or 32FC1, or a topic of
///   compressedDepth) with a camera, else clouds that are not organized with a camera; of several the one with the most
///   messages, of depth images before that one that is called depth, has a picture, is called rect, is not compressed;
/// - the camera (sensor_msgs/CameraInfo) whose name has the longest beginning in common with theirs; none for clouds of
///   a bag without any;
/// - beside depth images the picture of their frame_id and size, when there is one, raw or compressed.
/// A name in `wanted` also stands for NAME/compressedDepth and NAME/compressed where only these were recorded.
/// points and depth of `wanted` exclude each other. kBadInput names what the bag has instead.
objectness::Result<InputTopics> chooseTopics(const rosbag::Bag& bag, const InputTopics& wanted);

}  // namespace objectness_segmentation

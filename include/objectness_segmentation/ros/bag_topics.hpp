// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness_segmentation {

/// The topics of one depth camera.
struct InputTopics {
  std::string points, camera_info;
};

/// Topics of a bag that hold organized clouds (sensor_msgs/PointCloud2) and their camera (sensor_msgs/CameraInfo).
/// Those that are left empty in `wanted` are chosen: the organized clouds with the most messages, and the camera_info
/// whose name has the longest beginning in common with theirs. kBadInput names what the bag has instead.
objectness::Result<InputTopics> chooseTopics(const rosbag::Bag& bag, const InputTopics& wanted);

}  // namespace objectness_segmentation

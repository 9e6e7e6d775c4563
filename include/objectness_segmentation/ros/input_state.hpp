// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <string>

namespace objectness_segmentation {

/// What is known about the inputs: tells which of them is missing.
struct InputState {
  bool subscribed = false;
  std::string first_topic = "points", camera_topic = "camera_info";  ///< resolved; first: cloud or depth image
  std::size_t first_publishers = 0, camera_publishers = 0;
  std::size_t first_seen = 0, camera_infos_seen = 0, colors_seen = 0;  ///< paired or not
  std::size_t frames = 0;                                              ///< pairs, and clouds that go alone
  ros::Time first_stamp, camera_stamp;                                 ///< of the newest of each
  std::uint32_t dropped_frames = 0;
};

}  // namespace objectness_segmentation

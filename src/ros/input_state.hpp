// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <string>

namespace objectness_segmentation {

/// What is known about the inputs: tells which of them is missing.
struct InputState {
  bool subscribed = false;
  bool approximate = false;                                          ///< stamps need not be the same
  std::string first_topic = "points", camera_topic = "camera_info";  ///< resolved; first: cloud or depth image
  std::size_t first_publishers = 0, camera_publishers = 0;
  std::size_t first_seen = 0, camera_infos_seen = 0, colors_seen = 0;  ///< paired or not
  std::size_t frames = 0;                                              ///< handed on, with a camera_info or alone
  std::size_t with_last_camera = 0;     ///< frames with a camera_info that did not come with them
  ros::Time first_stamp, camera_stamp;  ///< of the newest of each
  std::string first_frame, camera_frame;
  std::uint32_t dropped_frames = 0;
};

}  // namespace objectness_segmentation

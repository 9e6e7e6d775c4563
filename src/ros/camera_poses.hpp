// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "objectness_segmentation/common/status.hpp"
#include "ros/node_settings.hpp"

namespace objectness_segmentation {

/// Where the camera was when a frame was taken.
struct CameraPose {
  objectness::Status status;  ///< kNoTransform: target or up frame are asked for and not known
  std::optional<Eigen::Isometry3d> T_target_camera;
  std::optional<Eigen::Vector3d> up;                ///< against gravity, optical frame, unit length
  std::optional<Eigen::Isometry3d> T_fixed_camera;  ///< none: without fixed frame, or not known yet
  std::string remark;                               ///< why T_fixed_camera is that of an earlier frame
};

/// Looks the camera up in tf, at the stamp of its frame. Subscribes to tf only when a frame is set.
class CameraPoses {
 public:
  CameraPoses(const NodeSettings& settings, const ros::NodeHandle& nh);

  /// Waits for tf no longer than the time-out (wall time: simulated time may stand still) and ends with `stop`.
  CameraPose at(const std_msgs::Header& header, const std::atomic<bool>& stop);

  /// Forgets what was known of another time; static transforms stay.
  void clear();

 private:
  using Deadline = std::chrono::steady_clock::time_point;
  objectness::Result<Eigen::Isometry3d> lookUp(const std::string& frame, const std_msgs::Header& header,
                                               Deadline deadline, const std::atomic<bool>& stop) const;

  std::string target_frame_, up_frame_, fixed_frame_;
  std::chrono::duration<double> timeout_;
  std::optional<Eigen::Isometry3d> last_T_fixed_camera_;
  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
};

}  // namespace objectness_segmentation

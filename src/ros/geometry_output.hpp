// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Point32.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>

#include <Eigen/Geometry>

namespace objectness_segmentation {

/// Of a message with the fields x, y and z.
template <class Message>
Message toXyz(const Eigen::Vector3d& p) {
  Message message;
  message.x = static_cast<decltype(message.x)>(p.x());
  message.y = static_cast<decltype(message.y)>(p.y());
  message.z = static_cast<decltype(message.z)>(p.z());
  return message;
}

inline geometry_msgs::Point toPoint(const Eigen::Vector3d& p) { return toXyz<geometry_msgs::Point>(p); }
inline geometry_msgs::Point32 toPoint32(const Eigen::Vector3d& p) { return toXyz<geometry_msgs::Point32>(p); }
inline geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& v) { return toXyz<geometry_msgs::Vector3>(v); }

/// The quaternion is a unit one to rounding, as rviz and tf demand.
inline geometry_msgs::Pose toPose(const Eigen::Isometry3d& transform) {
  geometry_msgs::Pose pose;
  pose.position = toPoint(transform.translation());
  const Eigen::Quaterniond q = Eigen::Quaterniond(transform.linear()).normalized();
  pose.orientation.x = q.x();
  pose.orientation.y = q.y();
  pose.orientation.z = q.z();
  pose.orientation.w = q.w();
  return pose;
}

}  // namespace objectness_segmentation

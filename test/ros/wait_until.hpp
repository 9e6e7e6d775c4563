// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>

namespace objectness_test {

constexpr double kTimeout = 60;  // seconds, wall time

/// Receives messages until the condition holds; false when it does not within the time.
inline bool waitUntil(const std::function<bool()>& condition, double seconds = kTimeout) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!condition()) {
    if (ros::WallTime::now() > end || !ros::ok()) return false;
    ros::spinOnce();
    ros::WallDuration(0.005).sleep();
  }
  return true;
}

}  // namespace objectness_test

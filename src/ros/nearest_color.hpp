// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/Image.h>

#include <cmath>

namespace objectness_segmentation {

/// The picture that goes with a depth image: the nearest in time, the last of several.
class NearestColor {
 public:
  /// Farther away it shows another moment.
  static constexpr double kMaxDistance_s = 0.1;

  explicit NearestColor(const ros::Time& stamp) : stamp_s_(stamp.toSec()) {}

  void consider(const sensor_msgs::ImageConstPtr& color) {
    const double distance_s = std::abs(color->header.stamp.toSec() - stamp_s_);
    if (distance_s > least_s_) return;
    least_s_ = distance_s;
    found_ = color;
  }
  /// Null when there is none.
  const sensor_msgs::ImageConstPtr& found() const { return found_; }

 private:
  double stamp_s_, least_s_ = kMaxDistance_s;
  sensor_msgs::ImageConstPtr found_;
};

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/view.h>
#include <sensor_msgs/Image.h>

#include <deque>
#include <string>
#include <vector>

#include "ros/nearest_color.hpp"
#include "ros/recorded_image.hpp"

namespace objectness_segmentation {

/// The pictures of a recording, read as far as they are needed.
class RecordedColors {
 public:
  /// topic: empty for none.
  RecordedColors(const rosbag::Bag& bag, const std::string& topic) {
    if (topic.empty()) return;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& entry : view) entries_.push_back(entry);
  }

  /// The one that goes with a depth image, of those that were recorded near to it; null when there is none. Depth
  /// images must be asked about in the order of the recording. Throws what reading a damaged bag throws.
  sensor_msgs::ImageConstPtr find(const ros::Time& stamp, const ros::Time& recorded) {
    const double recorded_s = recorded.toSec();
    while (next_ < entries_.size() && entries_[next_].getTime().toSec() <= recorded_s + kDelay_s) {
      const rosbag::MessageInstance& entry = entries_[next_++];
      const double time_s = entry.getTime().toSec();
      if (time_s >= recorded_s - kDelay_s) near_.push_back({time_s, readImage(entry)});
    }
    while (!near_.empty() && near_.front().recorded_s < recorded_s - kDelay_s) near_.pop_front();
    NearestColor nearest(stamp);
    for (const Read& color : near_) nearest.consider(color.message);
    return nearest.found();
  }

 private:
  /// Messages of one moment are recorded no farther apart.
  static constexpr double kDelay_s = 0.5;

  struct Read {
    double recorded_s;
    sensor_msgs::ImageConstPtr message;
  };
  std::vector<rosbag::MessageInstance> entries_;
  std::size_t next_ = 0;
  std::deque<Read> near_;
};

}  // namespace objectness_segmentation

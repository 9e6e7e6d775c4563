// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "objectness_segmentation/ros/bag_topics.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// A recording of a depth camera: its organized clouds, each with its camera_info.
class BagInput {
 public:
  /// Topics as in chooseTopics(). kBadInput: no such file, no bag, one without index, or without such topics.
  static objectness::Result<std::unique_ptr<BagInput>> open(const std::string& path, const InputTopics& wanted);

  const InputTopics& topics() const { return topics_; }
  std::size_t cloudCount() const { return cloud_count_; }

  /// Calls visit(messages, record time) for every cloud in the order of the recording, until it returns false.
  /// camera_info is the one with the cloud's stamp or, when approximate, the one with the nearest (the earlier of two);
  /// null when there is none. kBadInput where the file is damaged.
  using Visit = std::function<bool(const InputMessages&, const ros::Time&)>;
  objectness::Status forEachCloud(bool approximate, const Visit& visit) const;

 private:
  void load(const std::string& path, const InputTopics& wanted, objectness::Status& status);
  sensor_msgs::CameraInfoConstPtr findCamera(const ros::Time& stamp, bool approximate) const;

  rosbag::Bag bag_;
  InputTopics topics_;
  std::size_t cloud_count_ = 0;
  std::map<ros::Time, sensor_msgs::CameraInfoConstPtr> cameras_;  ///< by stamp
  std::string camera_damage_;                                     ///< why there are no more of them
};

}  // namespace objectness_segmentation

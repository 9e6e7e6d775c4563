// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "objectness_segmentation/ros/segment_messages.hpp"
#include "ros/bag_topics.hpp"

namespace objectness_segmentation {

class RecordedCameras;

/// A recording of a depth camera: its clouds or depth images, each with its camera_info.
class BagInput {
 public:
  BagInput();
  ~BagInput();

  /// Topics as in chooseTopics(). kBadInput: no such file, no bag, one without index, or without such topics.
  static objectness::Result<std::unique_ptr<BagInput>> open(const std::string& path, const InputTopics& wanted);

  const InputTopics& topics() const { return topics_; }
  std::size_t frameCount() const { return frame_count_; }
  /// "cloud" or "depth image".
  const char* frameName() const { return topics_.ofDepth() ? "depth image" : "cloud"; }

  /// Calls visit(messages, record time) for every cloud or depth image in the order of the recording, until it returns
  /// false. camera_info is the one with the same stamp or, when approximate, the one with the nearest (the earlier of
  /// two). Where none has the same stamp it is the last one of the same frame_id that was recorded until then (else the
  /// first one), null when there is none. With a depth image comes the picture that is nearest in time, when there is
  /// one. kBadInput where the file is damaged.
  using Visit = std::function<bool(const InputMessages&, const ros::Time&)>;
  objectness::Status forEachFrame(bool approximate, const Visit& visit) const;

 private:
  void load(const std::string& path, const InputTopics& wanted, objectness::Status& status);
  sensor_msgs::CameraInfoConstPtr findCamera(const std_msgs::Header& header, const ros::Time& recorded,
                                             bool approximate) const;

  rosbag::Bag bag_;
  InputTopics topics_;
  std::size_t frame_count_ = 0;
  std::unique_ptr<RecordedCameras> cameras_;
  std::string camera_damage_;  ///< why there are no more of them
};

}  // namespace objectness_segmentation

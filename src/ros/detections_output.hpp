// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// ~detections: vision_msgs/Detection3DArray, a box and a hypothesis (id = label, score = objectness) an object.
class DetectionsOutput {
 public:
  void advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed);
  bool haveSubscribers() const { return publisher_.getNumSubscribers() > 0; }
  void publish(const SegmentedFrame& result, const std_msgs::Header& header);

 private:
  ros::Publisher publisher_;
};

}  // namespace objectness_segmentation

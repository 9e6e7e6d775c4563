// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <set>
#include <string>

#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// ~planning_scene: moveit_msgs/PlanningScene, a difference to be remapped to MoveIt's /planning_scene. The boxes of
/// the objects as collision objects "object_LABEL"; those of the frame before that are no longer there are removed.
class PlanningSceneOutput {
 public:
  void advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed);
  bool haveSubscribers() const { return publisher_.getNumSubscribers() > 0; }
  void publish(const SegmentedFrame& result, const std_msgs::Header& header);

 private:
  ros::Publisher publisher_;
  std::set<std::string> shown_;
};

}  // namespace objectness_segmentation

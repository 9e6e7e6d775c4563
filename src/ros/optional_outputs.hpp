// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <set>
#include <string>

#include "objectness_segmentation/ros/segment_messages.hpp"

#ifdef OBJECTNESS_WITH_VISION_MSGS
#include "ros/detections_output.hpp"
#endif
#ifdef OBJECTNESS_WITH_MOVEIT_MSGS
#include "ros/planning_scene_output.hpp"
#endif

namespace objectness_segmentation {

/// Topics of packages that need not be there: found by CMake, or left out.
class OptionalOutputs {
 public:
  void advertise([[maybe_unused]] ros::NodeHandle& nh, [[maybe_unused]] bool latch,
                 [[maybe_unused]] const ros::SubscriberStatusCallback& changed) {
#ifdef OBJECTNESS_WITH_VISION_MSGS
    detections_.advertise(nh, latch, changed);
#endif
#ifdef OBJECTNESS_WITH_MOVEIT_MSGS
    planning_scene_.advertise(nh, latch, changed);
#endif
  }

  bool haveSubscribers() const {
    bool have = false;
#ifdef OBJECTNESS_WITH_VISION_MSGS
    have = have || detections_.haveSubscribers();
#endif
#ifdef OBJECTNESS_WITH_MOVEIT_MSGS
    have = have || planning_scene_.haveSubscribers();
#endif
    return have;
  }

  void publish([[maybe_unused]] const SegmentedFrame& result, [[maybe_unused]] const std_msgs::Header& header) {
#ifdef OBJECTNESS_WITH_VISION_MSGS
    detections_.publish(result, header);
#endif
#ifdef OBJECTNESS_WITH_MOVEIT_MSGS
    planning_scene_.publish(result, header);
#endif
  }

 private:
#ifdef OBJECTNESS_WITH_VISION_MSGS
  DetectionsOutput detections_;
#endif
#ifdef OBJECTNESS_WITH_MOVEIT_MSGS
  PlanningSceneOutput planning_scene_;
#endif
};

}  // namespace objectness_segmentation

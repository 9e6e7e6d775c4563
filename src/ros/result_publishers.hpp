// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <optional>
#include <string>
#include <vector>

#include "ros/frame_processor.hpp"
#include "ros/optional_outputs.hpp"
#include "ros/output_messages.hpp"

namespace objectness_segmentation {

/// All topics of the nodelet. What nobody subscribes to is not computed.
class ResultPublishers {
 public:
  /// changed: a subscriber came or went.
  void advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed);

  bool haveSubscribers() const;

  /// input: header of what came in; target_frame: where the results are moved to when the frame has such a pose.
  /// Returns the message of ~objects when somebody subscribes to it or it is asked for.
  SegmentedObjectArrayConstPtr publish(ProcessedFrame& frame, const std_msgs::Header& input,
                                       const std::string& target_frame, const objectness::Config& config,
                                       const FrameFacts& facts, bool objects_wanted);

 private:
  void publishProfile(const ProcessedFrame& frame, const std_msgs::Header& input, const FrameFacts& facts) const;

  ros::Publisher objects_, segments_, markers_, poses_, table_, label_image_, profile_, edges_, hidden_, superpixels_;
  OptionalOutputs optional_;
};

}  // namespace objectness_segmentation

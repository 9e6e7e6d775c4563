// SPDX-License-Identifier: BSD-3-Clause
// Built only where vision_msgs is found.
#include "ros/detections_output.hpp"

#include <vision_msgs/Detection3DArray.h>

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/geometry_output.hpp"

namespace objectness_segmentation {

void DetectionsOutput::advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed) {
  publisher_ = nh.advertise<vision_msgs::Detection3DArray>(topics::kDetections, kPublisherQueueSize, changed, changed,
                                                           {}, latch);
}

void DetectionsOutput::publish(const SegmentedFrame& result, const std_msgs::Header& header) {
  if (!haveSubscribers()) return;
  vision_msgs::Detection3DArray message;
  message.header = header;
  const auto& segmentation = result.segmentation;
  for (std::size_t rank = 0; segmentation.status.ok() && rank < segmentation.segments.size(); ++rank) {
    const objectness::Segment& segment = segmentation.segments[rank];
    vision_msgs::Detection3D detection;
    detection.header = header;
    detection.bbox.center = toPose(segment.box.T_camera_box);
    detection.bbox.size = toVector3(segment.box.size_m);
    vision_msgs::ObjectHypothesisWithPose hypothesis;
    hypothesis.id = identityOf(result, rank).label;
    hypothesis.score = segment.objectness;
    hypothesis.pose.pose = detection.bbox.center;
    detection.results.push_back(hypothesis);
    message.detections.push_back(detection);
  }
  publisher_.publish(message);
}

}  // namespace objectness_segmentation

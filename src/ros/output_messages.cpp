// SPDX-License-Identifier: BSD-3-Clause
#include "ros/output_messages.hpp"

#include <boost/make_shared.hpp>

#include "objectness_segmentation/ros/output_conversions.hpp"

namespace objectness_segmentation {

SegmentedObjectArrayPtr OutputMessages::objects() const {
  auto message = boost::make_shared<SegmentedObjectArray>(toObjectsMessage(result_, header_));
  message->processing_time = static_cast<float>(facts_.processing_time_s);
  message->dropped_frames = facts_.dropped_frames;
  return message;
}

sensor_msgs::PointCloud2Ptr OutputMessages::segments() const {
  return boost::make_shared<sensor_msgs::PointCloud2>(toSegmentsCloud(result_, header_));
}

visualization_msgs::MarkerArrayPtr OutputMessages::markers() const {
  return boost::make_shared<visualization_msgs::MarkerArray>(toMarkers(result_, header_));
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/SegmentedObjectArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "objectness_segmentation/ros/segment_messages.hpp"

namespace objectness_segmentation {

/// What is known about a frame beside its result; all 0 where output must be the same in every run.
struct FrameFacts {
  double processing_time_s = 0;      ///< from the frame's take-up to its result
  std::uint32_t dropped_frames = 0;  ///< replaced before they were taken up, since the start
};

/// The messages about one frame, for topics::kObjects, kSegments and kMarkers, each made when asked for. All carry the
/// given header. Holds references: lives no longer than what it was made of.
class OutputMessages {
 public:
  OutputMessages(const SegmentedFrame& result, const std_msgs::Header& header, const FrameFacts& facts)
      : result_(result), header_(header), facts_(facts) {}

  SegmentedObjectArrayPtr objects() const;
  sensor_msgs::PointCloud2Ptr segments() const;
  visualization_msgs::MarkerArrayPtr markers() const;

 private:
  const SegmentedFrame& result_;
  const std_msgs::Header& header_;
  FrameFacts facts_;
};

}  // namespace objectness_segmentation

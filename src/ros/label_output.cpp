// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include "objectness_segmentation/ros/output_conversions.hpp"

namespace objectness_segmentation {

sensor_msgs::Image toLabelImage(const SegmentedFrame& result, const std_msgs::Header& header) {
  cv::Mat_<ushort> labels(result.frame.height(), result.frame.width(), ushort{0});
  if (result.segmentation.status.ok() && !labels.empty()) {
    // The table, from the image by rank; the objects' own pixels with their labels over it.
    result.segmentation.labels.copyTo(labels);
    const auto labelOf = [&](std::size_t rank) { return static_cast<ushort>(identityOf(result, rank).label); };
    for (const int pixel : result.frame.bridged) {
      ushort& label = labels.ptr<ushort>()[pixel];
      if (label >= objectness::kFirstObjectLabel) label = labelOf(label - objectness::kFirstObjectLabel);
    }
    for (std::size_t rank = 0; rank < result.segmentation.segments.size(); ++rank) {
      for (const int pixel : result.segmentation.segments[rank].pixels) labels.ptr<ushort>()[pixel] = labelOf(rank);
    }
  }
  if (result.step > 1) {
    cv::Mat_<ushort> full(result.input_height, result.input_width, ushort{0});
    for (int v = 0; v < full.rows && !labels.empty(); ++v) {
      for (int u = 0; u < full.cols; ++u) full(v, u) = labels(v / result.step, u / result.step);
    }
    labels = full;
  }
  return *cv_bridge::CvImage(header, sensor_msgs::image_encodings::TYPE_16UC1, labels).toImageMsg();
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// The frame's points where `mask` is not zero, NaN elsewhere; all of them without a mask.
inline pcl::PointCloud<pcl::PointXYZ>::Ptr organizedCloud(const Frame& frame, const cv::Mat_<uchar>& mask = {}) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  Cloud::Ptr cloud(new Cloud(frame.width(), frame.height(), pcl::PointXYZ(kNaN, kNaN, kNaN)));
  for (int i = 0; i < frame.size(); ++i) {
    if (mask.empty() || mask(i / frame.width(), i % frame.width())) {
      cloud->points[i].getVector3fMap() = frame.points[i];
    }
  }
  cloud->is_dense = false;
  return cloud;
}

}  // namespace objectness

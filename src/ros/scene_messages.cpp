// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/scene_messages.hpp"

#include <sensor_msgs/distortion_models.h>

#include <numeric>

#include "cloud_output.hpp"

namespace objectness_segmentation {

sensor_msgs::PointCloud2 toCloudMessage(const objectness::Frame& frame, const std_msgs::Header& header) {
  std::vector<int> all(frame.points.size());
  std::iota(all.begin(), all.end(), 0);
  sensor_msgs::PointCloud2 cloud = extractCloud(frame, all, header);
  cloud.width = static_cast<std::uint32_t>(frame.width());
  cloud.height = static_cast<std::uint32_t>(frame.height());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = false;
  return cloud;
}

sensor_msgs::CameraInfo toCameraInfo(const objectness::PinholeCamera& camera, const std_msgs::Header& header) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(5, 0.0);
  info.K = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace objectness_segmentation

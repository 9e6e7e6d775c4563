// SPDX-License-Identifier: BSD-3-Clause
#include "ros/scene_messages.hpp"

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/fill_image.h>
#include <sensor_msgs/image_encodings.h>

#include <numeric>

#include "ros/cloud_output.hpp"
#include "ros/geometry_output.hpp"

namespace objectness_segmentation {
namespace {

sensor_msgs::Image toImage(const cv::Mat& image, const std::string& encoding, const std_msgs::Header& header) {
  sensor_msgs::Image message;
  const cv::Mat packed = image.isContinuous() ? image : image.clone();
  sensor_msgs::fillImage(message, encoding, static_cast<std::uint32_t>(packed.rows),
                         static_cast<std::uint32_t>(packed.cols), static_cast<std::uint32_t>(packed.step), packed.data);
  message.header = header;
  return message;
}

}  // namespace

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

sensor_msgs::Image toImageMessage(const cv::Mat_<cv::Vec3b>& image, const std_msgs::Header& header) {
  return toImage(image, sensor_msgs::image_encodings::BGR8, header);
}

sensor_msgs::Image toImageMessage(const cv::Mat_<ushort>& image, const std_msgs::Header& header) {
  return toImage(image, sensor_msgs::image_encodings::TYPE_16UC1, header);
}

geometry_msgs::TransformStamped toTransformMessage(const Eigen::Isometry3d& T_parent_child,
                                                   const std_msgs::Header& header, const std::string& child_frame) {
  const geometry_msgs::Pose pose = toPose(T_parent_child);
  geometry_msgs::TransformStamped message;
  message.header = header;
  message.child_frame_id = child_frame;
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.translation.z = pose.position.z;
  message.transform.rotation = pose.orientation;
  return message;
}

Eigen::Isometry3d opticalToBody() {
  Eigen::Isometry3d T_body_optical = Eigen::Isometry3d::Identity();
  T_body_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T_body_optical;
}

}  // namespace objectness_segmentation

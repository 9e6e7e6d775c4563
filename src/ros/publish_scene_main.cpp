// SPDX-License-Identifier: BSD-3-Clause
// Plays a camera driver with a scene from files: the organized cloud and its camera_info, again and again.
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <cstdio>
#include <string>

#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/scene_messages.hpp"

int main(int argc, char** argv) {
  using namespace objectness_segmentation;
  ros::init(argc, argv, "publish_scene");
  ros::NodeHandle nh;
  const ros::NodeHandle private_nh("~");
  const auto path = private_nh.param<std::string>("scene", "");
  const auto frame_id = private_nh.param<std::string>("frame_id", "camera_optical_frame");
  const auto parent = private_nh.param<std::string>("parent_frame_id", "camera_link");
  const double rate_hz = private_nh.param("rate_hz", 1.0);
  if (path.empty() || !(rate_hz > 0)) {
    std::fprintf(stderr, "publish_scene: ~scene (a scene folder or a .pcd file) is needed, and ~rate_hz above 0\n");
    return 1;
  }
  const auto frame = objectness::loadInput(path, std::nullopt, {});
  if (!frame.ok()) {
    std::fprintf(stderr, "publish_scene: %s: %s\n", path.c_str(), frame.status.message.c_str());
    return 1;
  }

  tf2_ros::StaticTransformBroadcaster broadcaster;
  std_msgs::Header body;
  body.frame_id = parent;
  broadcaster.sendTransform(toTransformMessage(opticalToBody(), body, frame_id));
  const auto clouds = nh.advertise<sensor_msgs::PointCloud2>(topics::kPoints, kPublisherQueueSize);
  const auto cameras = nh.advertise<sensor_msgs::CameraInfo>(topics::kCameraInfo, kPublisherQueueSize);
  sensor_msgs::PointCloud2 cloud = toCloudMessage(frame.value, {});
  sensor_msgs::CameraInfo camera_info = toCameraInfo(frame.value.camera, {});
  cloud.header.frame_id = camera_info.header.frame_id = frame_id;
  const auto publish = [&](const ros::WallTimerEvent&) {
    cloud.header.stamp = camera_info.header.stamp = ros::Time::now();
    cameras.publish(camera_info);
    clouds.publish(cloud);
  };
  const ros::WallTimer timer = nh.createWallTimer(ros::WallDuration(1.0 / rate_hz), publish);
  ros::spin();
  return 0;
}

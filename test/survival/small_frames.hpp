// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <boost/make_shared.hpp>
#include <vector>

#include "fixtures/ray_cast.hpp"
#include "fixtures/ros_messages.hpp"
#include "ros/scene_messages.hpp"

namespace objectness_test {

constexpr char kFrameId[] = "camera_optical_frame";

/// A view of boxes on a table: `variant` says how many and where. 160 x 120 when scale is 1.
inline Scene tableScene(int variant, int scale = 1) {
  Scene scene;
  scene.camera = {131.25 * scale, 131.25 * scale, 80.0 * scale - 0.5, 60.0 * scale - 0.5, 160 * scale, 120 * scale};
  scene.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0)};
  for (int k = 0; k <= variant % 3; ++k) {
    const double x = -0.25 + 0.2 * k + 0.015 * (variant % 5), y = -0.05 + 0.02 * (variant % 4);
    scene.surfaces.push_back(box({x, y, 0}, {x + 0.11, y + 0.09, 0.08 + 0.02 * k}));
  }
  return scene;
}

/// Messages of table scenes that differ, as a camera would send them.
class SmallFrames {
 public:
  explicit SmallFrames(int count, int scale = 1) {
    for (int variant = 0; variant < count; ++variant) {
      Scene scene = tableScene(variant, scale);
      camera_info_ = objectness_segmentation::toCameraInfo(scene.camera, {});
      Layout layout;
      layout.point_step = 16;
      layout.has_rgb = false;
      clouds_.push_back(makeCloudMessage(scene.render(), layout, makeHeader(0, kFrameId)));
    }
  }
  std::size_t size() const { return clouds_.size(); }
  sensor_msgs::PointCloud2ConstPtr cloud(std::size_t number, const ros::Time& stamp) const {
    auto message = boost::make_shared<sensor_msgs::PointCloud2>(clouds_[number % clouds_.size()]);
    message->header.stamp = stamp;
    return message;
  }
  sensor_msgs::CameraInfoConstPtr cameraInfo(const ros::Time& stamp) const {
    auto message = boost::make_shared<sensor_msgs::CameraInfo>(camera_info_);
    message->header.stamp = stamp;
    message->header.frame_id = kFrameId;
    return message;
  }

 private:
  std::vector<sensor_msgs::PointCloud2> clouds_;
  sensor_msgs::CameraInfo camera_info_;
};

}  // namespace objectness_test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/loader.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "small_frames.hpp"

namespace objectness_test {

using objectness_segmentation::SegmentedObjectArray;
using objectness_segmentation::SegmentedObjectArrayConstPtr;

/// Nodelets in the process of the test: messages go from hand to hand, so none is lost on the way and every frame and
/// result can be counted.
class HostedNodelets {
 public:
  HostedNodelets() : loader_(false) {
    // Longer than anything a test sends at once.
    clouds_ = nh_.advertise<sensor_msgs::PointCloud2>("points", kQueue);
    cameras_ = nh_.advertise<sensor_msgs::CameraInfo>("camera_info", kQueue);
  }

  bool load(const std::string& name) {
    ros::param::set(name + "/queue_size", kQueue);
    return loader_.load(name, "objectness_segmentation/SegmentObjects", {}, {});
  }
  bool unload(const std::string& name) { return loader_.unload(name); }

  /// Both inputs have this many subscribers.
  bool connected(std::uint32_t count) const {
    return clouds_.getNumSubscribers() == count && cameras_.getNumSubscribers() == count;
  }

  /// Sends the frame with the number and returns its stamp, which no other frame has.
  ros::Time send(const SmallFrames& frames, std::size_t number) {
    last_stamp_ += ros::Duration(0, 1000000);
    cameras_.publish(frames.cameraInfo(last_stamp_));
    clouds_.publish(frames.cloud(number, last_stamp_));
    return last_stamp_;
  }

 private:
  static constexpr int kQueue = 1000;

  ros::NodeHandle nh_;
  nodelet::Loader loader_;
  ros::Publisher clouds_, cameras_;
  ros::Time last_stamp_{1000};
};

/// Hands every result of a nodelet to `receive`.
inline ros::Subscriber listen(const std::string& nodelet,
                              const std::function<void(const SegmentedObjectArrayConstPtr&)>& receive) {
  return ros::NodeHandle().subscribe<SegmentedObjectArray>(nodelet + "/objects", 4096, receive);
}

/// Handles callbacks until the condition holds.
inline bool spinUntil(const std::function<bool()>& condition, double seconds = 60) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!condition()) {
    if (ros::WallTime::now() > end || !ros::ok()) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002));
  }
  return true;
}

}  // namespace objectness_test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <functional>
#include <memory>

namespace objectness_segmentation {

/// Pairs of cloud and camera_info with the same stamp (or, when approximate, the nearest ones).
class SynchronizedInputs {
 public:
  using Callback = std::function<void(const sensor_msgs::PointCloud2ConstPtr&, const sensor_msgs::CameraInfoConstPtr&)>;

  /// Subscribes to nothing yet. Callbacks come through nh's queue, none after unsubscribe() has returned there.
  SynchronizedInputs(const ros::NodeHandle& nh, int queue_size, bool approximate, Callback callback);
  ~SynchronizedInputs();

  void subscribe();
  void unsubscribe();
  bool subscribed() const { return subscribed_; }

  /// Messages that came in on each topic since the last subscribe(), paired or not: tells which input is missing.
  std::size_t cloudsSeen() const { return clouds_seen_; }
  std::size_t cameraInfosSeen() const { return camera_infos_seen_; }

 private:
  using Cloud = sensor_msgs::PointCloud2;
  using Camera = sensor_msgs::CameraInfo;
  using Exact = message_filters::sync_policies::ExactTime<Cloud, Camera>;
  using Approximate = message_filters::sync_policies::ApproximateTime<Cloud, Camera>;

  void forward(const sensor_msgs::PointCloud2ConstPtr& cloud, const sensor_msgs::CameraInfoConstPtr& camera);
  void countCloud(const sensor_msgs::PointCloud2ConstPtr&) { ++clouds_seen_; }
  void countCamera(const sensor_msgs::CameraInfoConstPtr&) { ++camera_infos_seen_; }

  ros::NodeHandle nh_;
  int queue_size_;
  Callback callback_;
  message_filters::Subscriber<Cloud> clouds_;
  message_filters::Subscriber<Camera> cameras_;
  // After the subscribers: a synchronizer must be gone before what it listens to (ros_comm issue 720).
  std::unique_ptr<message_filters::Synchronizer<Exact>> exact_;
  std::unique_ptr<message_filters::Synchronizer<Approximate>> approximate_;
  std::atomic<bool> subscribed_{false};
  std::atomic<std::size_t> clouds_seen_{0}, camera_infos_seen_{0};
};

}  // namespace objectness_segmentation

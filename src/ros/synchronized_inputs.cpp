// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/synchronized_inputs.hpp"

#include <utility>

#include "objectness_segmentation/ros/topics.hpp"

namespace objectness_segmentation {

SynchronizedInputs::SynchronizedInputs(const ros::NodeHandle& nh, int queue_size, bool approximate, Callback callback)
    : nh_(nh), queue_size_(queue_size), callback_(std::move(callback)) {
  const auto size = static_cast<std::uint32_t>(queue_size);
  if (approximate) {
    approximate_ = std::make_unique<message_filters::Synchronizer<Approximate>>(Approximate(size), clouds_, cameras_);
    approximate_->registerCallback(&SynchronizedInputs::forward, this);
  } else {
    exact_ = std::make_unique<message_filters::Synchronizer<Exact>>(Exact(size), clouds_, cameras_);
    exact_->registerCallback(&SynchronizedInputs::forward, this);
  }
  clouds_.registerCallback(&SynchronizedInputs::countCloud, this);
  cameras_.registerCallback(&SynchronizedInputs::countCamera, this);
}

SynchronizedInputs::~SynchronizedInputs() { unsubscribe(); }

void SynchronizedInputs::subscribe() {
  if (subscribed_.exchange(true)) return;
  clouds_seen_ = camera_infos_seen_ = 0;
  const auto size = static_cast<std::uint32_t>(queue_size_);
  cameras_.subscribe(nh_, topics::kCameraInfo, size);
  clouds_.subscribe(nh_, topics::kPoints, size);
}

void SynchronizedInputs::unsubscribe() {
  if (!subscribed_.exchange(false)) return;
  clouds_.unsubscribe();
  cameras_.unsubscribe();
}

void SynchronizedInputs::forward(const sensor_msgs::PointCloud2ConstPtr& cloud,
                                 const sensor_msgs::CameraInfoConstPtr& camera) {
  callback_(cloud, camera);
}

}  // namespace objectness_segmentation

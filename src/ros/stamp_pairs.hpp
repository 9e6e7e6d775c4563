// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <sensor_msgs/CameraInfo.h>

#include <functional>
#include <memory>
#include <utility>

namespace objectness_segmentation {

/// Messages and camera_infos of the same stamp (or, when approximate, the nearest ones), paired as they are added.
/// clear() may be called between two calls of add(), which a synchronizer behind message_filters' own subscribers
/// would not allow: it is what a jump in time needs.
template <class First>
class StampPairs {
 public:
  using FirstPtr = boost::shared_ptr<const First>;
  using Callback = std::function<void(const FirstPtr&, const sensor_msgs::CameraInfoConstPtr&)>;

  StampPairs(int queue_size, bool approximate, Callback callback)
      : queue_size_(static_cast<std::uint32_t>(queue_size)),
        use_approximate_(approximate),
        callback_(std::move(callback)) {
    clear();
  }

  void clear() {
    if (use_approximate_) {
      approximate_ = std::make_unique<message_filters::Synchronizer<Approximate>>(Approximate(queue_size_));
      approximate_->registerCallback(&StampPairs::forward, this);
    } else {
      exact_ = std::make_unique<message_filters::Synchronizer<Exact>>(Exact(queue_size_));
      exact_->registerCallback(&StampPairs::forward, this);
    }
  }

  void addFirst(const FirstPtr& message) {
    if (exact_) exact_->template add<0>(message);
    if (approximate_) approximate_->template add<0>(message);
  }
  void addCamera(const sensor_msgs::CameraInfoConstPtr& camera) {
    if (exact_) exact_->template add<1>(camera);
    if (approximate_) approximate_->template add<1>(camera);
  }

 private:
  using Exact = message_filters::sync_policies::ExactTime<First, sensor_msgs::CameraInfo>;
  using Approximate = message_filters::sync_policies::ApproximateTime<First, sensor_msgs::CameraInfo>;

  void forward(const FirstPtr& first, const sensor_msgs::CameraInfoConstPtr& camera) { callback_(first, camera); }

  std::uint32_t queue_size_;
  bool use_approximate_;
  Callback callback_;
  std::unique_ptr<message_filters::Synchronizer<Exact>> exact_;
  std::unique_ptr<message_filters::Synchronizer<Approximate>> approximate_;
};

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/SegmentOnce.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <string>

#include "ros/pending_requests.hpp"

namespace objectness_segmentation {

/// The service ~segment. It waits in a thread and on a callback queue of its own, so that frames go on coming; one
/// request after the other.
class SegmentService {
 public:
  using Requests = PendingRequests<SegmentedObjectArrayConstPtr>;
  using RequestId = Requests::RequestId;

  /// changed: requests began or ceased to wait. missing: why no frame may have come.
  SegmentService(ros::NodeHandle& nh, Requests& requests, double default_timeout_s, std::function<void()> changed,
                 std::function<std::string()> missing);
  ~SegmentService() { stop(); }

  /// Answers who waits with kCancelled, and ends the thread. May be called again.
  void stop();

 private:
  bool answer(SegmentOnce::Request& request, SegmentOnce::Response& response);

  Requests& requests_;
  double default_timeout_s_;
  std::function<void()> changed_;
  std::function<std::string()> missing_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace objectness_segmentation

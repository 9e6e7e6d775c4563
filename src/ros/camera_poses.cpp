// SPDX-License-Identifier: BSD-3-Clause
#include "ros/camera_poses.hpp"

#include <tf2_eigen/tf2_eigen.h>

#include <chrono>
#include <thread>
#include <utility>

#include "ros/frame_names.hpp"

namespace objectness_segmentation {
namespace {

using objectness::Result;
using objectness::Status;
using objectness::StatusCode;

constexpr std::chrono::milliseconds kPoll{2};

}  // namespace

CameraPoses::CameraPoses(const NodeSettings& settings, const ros::NodeHandle& nh)
    : target_frame_(settings.target_frame),
      up_frame_(settings.up_frame),
      fixed_frame_(settings.fixed_frame),
      timeout_(settings.transform_timeout_s) {
  if (target_frame_.empty() && up_frame_.empty() && fixed_frame_.empty()) return;
  buffer_ = std::make_unique<tf2_ros::Buffer>();
  listener_ = std::make_unique<tf2_ros::TransformListener>(*buffer_, nh);  // in a thread of its own
}

void CameraPoses::clear() {
  if (buffer_) buffer_->clear();
}

Result<Eigen::Isometry3d> CameraPoses::lookUp(const std::string& frame, const std_msgs::Header& header,
                                              Deadline deadline, const std::atomic<bool>& stop) const {
  using Pose = Result<Eigen::Isometry3d>;
  if (header.frame_id.empty()) {
    return Pose::error(StatusCode::kNoTransform,
                       "the input has no frame_id: its pose in " + frame + " is not known; set the driver's frame_id");
  }
  const std::string camera = withoutSlash(header.frame_id);
  std::string why;
  const auto isKnown = [&] {
    why.clear();  // it would be written to its end
    return buffer_->canTransform(frame, camera, header.stamp, &why);
  };
  while (!isKnown()) {
    if (stop || std::chrono::steady_clock::now() >= deadline) {
      return Pose::error(StatusCode::kNoTransform, "no transform from " + camera + " to " + frame +
                                                       " at the time of the frame (~transform_timeout): " + why);
    }
    std::this_thread::sleep_for(kPoll);
  }
  try {
    return {{}, tf2::transformToEigen(buffer_->lookupTransform(frame, camera, header.stamp))};
  } catch (const tf2::TransformException& e) {  // cleared in between
    return Pose::error(StatusCode::kNoTransform, "no transform from " + camera + " to " + frame + ": " + e.what());
  }
}

CameraPose CameraPoses::at(const std_msgs::Header& header, const std::atomic<bool>& stop) {
  CameraPose pose;
  const Deadline deadline =
      std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(timeout_);
  if (!target_frame_.empty()) {
    const auto found = lookUp(target_frame_, header, deadline, stop);
    pose.status = found.status;
    if (found.ok()) pose.T_target_camera = found.value;
  }
  if (!up_frame_.empty() && pose.status.ok()) {
    const auto found = lookUp(up_frame_, header, deadline, stop);
    pose.status = found.status;
    if (found.ok()) pose.up = found.value.linear().transpose() * Eigen::Vector3d::UnitZ();
  }
  if (!fixed_frame_.empty() && pose.status.ok()) {
    const auto found = lookUp(fixed_frame_, header, deadline, stop);
    if (found.ok()) last_T_fixed_camera_ = found.value;
    if (!found.ok()) pose.remark = found.status.message + ": objects are followed as if the camera stood still";
  }
  pose.T_fixed_camera = last_T_fixed_camera_;
  return pose;
}

}  // namespace objectness_segmentation

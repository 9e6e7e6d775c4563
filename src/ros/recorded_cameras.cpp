// SPDX-License-Identifier: BSD-3-Clause
#include "ros/recorded_cameras.hpp"

#include <cmath>
#include <iterator>

#include "ros/frame_names.hpp"

namespace objectness_segmentation {
namespace {

using CameraInfoPtr = sensor_msgs::CameraInfoConstPtr;

/// ros::Duration throws where the difference is too long for it.
double secondsBetween(const ros::Time& from, const ros::Time& to) { return std::abs(to.toSec() - from.toSec()); }

/// The last one until `time` of those that fit, else the first after it.
template <class Cameras, class Fits>
CameraInfoPtr lastUntil(const Cameras& cameras, const ros::Time& time, const Fits& fits) {
  const auto later = cameras.upper_bound(time);
  for (auto camera = later; camera != cameras.begin();) {
    --camera;
    if (fits(camera->second)) return camera->second;
  }
  for (auto camera = later; camera != cameras.end(); ++camera) {
    if (fits(camera->second)) return camera->second;
  }
  return nullptr;
}

}  // namespace

void RecordedCameras::add(const CameraInfoPtr& camera, const ros::Time& recorded) {
  by_stamp_[camera->header.stamp].emplace(recorded, camera);
  all_.emplace(recorded, camera);
}

CameraInfoPtr RecordedCameras::find(const std_msgs::Header& header, const ros::Time& recorded, bool approximate) const {
  const auto any = [](const CameraInfoPtr&) { return true; };
  auto group = by_stamp_.lower_bound(header.stamp);
  const bool same = group != by_stamp_.end() && group->first == header.stamp;
  if (!same && (!approximate || header.stamp.isZero())) {  // a stamp of 0 is near to none
    return lastUntil(all_, recorded, [&](const CameraInfoPtr& camera) {
      return approximate || mayBeSameFrame(camera->header.frame_id, header.frame_id);
    });
  }
  if (by_stamp_.empty()) return nullptr;
  if (!same && group != by_stamp_.begin()) {
    const auto earlier = std::prev(group);
    if (group == by_stamp_.end() ||
        secondsBetween(earlier->first, header.stamp) <= secondsBetween(header.stamp, group->first)) {
      group = earlier;
    }
  }
  return lastUntil(group->second, recorded, any);
}

bool RecordedCameras::reachBeyond(const ros::Time& stamp, const ros::Time& recorded) const {
  return !all_.empty() && by_stamp_.rbegin()->first > stamp && all_.rbegin()->first > recorded;
}

}  // namespace objectness_segmentation

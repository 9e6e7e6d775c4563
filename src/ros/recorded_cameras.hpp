// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>

#include <map>
#include <string>

namespace objectness_segmentation {

/// The camera_infos of a recording, and which of them goes with an input: as CameraPartners chooses while they come,
/// but what comes later is known, too.
class RecordedCameras {
 public:
  /// In the order of the recording.
  void add(const sensor_msgs::CameraInfoConstPtr& camera, const ros::Time& recorded);

  /// The one of the same stamp or, when approximate, of the nearest one (the earlier of two). Otherwise, as of several
  /// with one stamp, the last one that was recorded until then, else the first: of the same frame_id, when approximate
  /// of any. Null when there is none.
  sensor_msgs::CameraInfoConstPtr find(const std_msgs::Header& header, const ros::Time& recorded,
                                       bool approximate) const;

  bool holds(const ros::Time& stamp) const { return by_stamp_.count(stamp) > 0; }
  /// Whether something was recorded, and has a stamp, after these.
  bool reachBeyond(const ros::Time& stamp, const ros::Time& recorded) const;

 private:
  using Recorded = std::multimap<ros::Time, sensor_msgs::CameraInfoConstPtr>;  ///< by time of recording

  std::map<ros::Time, Recorded> by_stamp_;
  Recorded all_;
};

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// What the camera knows of a place.
enum class Seen {
  kUnknown,      ///< out of the picture, or no depth there
  kFree,         ///< it looks through
  kOwn,          ///< on or behind the surface of the object itself
  kBehindOther,  ///< something else hides it
  kOther,        ///< on the surface of something else
};

/// The space around one object as the camera sees it.
class SeenSpace {
 public:
  /// labels: of all pixels; own: that of the object. All are kept by reference.
  SeenSpace(const Frame& frame, const Table& table, const cv::Mat_<ushort>& labels, int own)
      : frame_(frame), labels_(labels), own_(own), T_camera_table_(table.T_table_camera.inverse()) {}

  /// place: table frame.
  Seen at(const Eigen::Vector3d& place) const;

 private:
  const Frame& frame_;
  const cv::Mat_<ushort>& labels_;
  int own_;
  Eigen::Isometry3d T_camera_table_;
};

}  // namespace objectness

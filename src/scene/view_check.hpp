// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Where a camera sees a point.
struct SeenAt {
  bool inside = false;                               ///< within the image and in front of the camera
  int u = 0, v = 0;                                  ///< the nearest pixel
  Eigen::Vector2f offset = Eigen::Vector2f::Zero();  ///< from its centre, pixels
};

SeenAt lookAt(const Eigen::Vector3f& point, const PinholeCamera& camera);

/// Whether a list of points is a view of the camera: a depth image's points, some of which may be missing.
/// kNoValidPoints, or kNotOrganized when
/// - they do not lie on the camera's pixels: another camera took them, or they are given in another frame;
/// - they were averaged, as by a voxel grid: points lie between pixel centres, and pixels around them are empty;
/// - they were thinned out so far that most pixels around them are empty.
Status checkIsView(const RawCloud& cloud, const PinholeCamera& camera);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {

using objectness::PinholeCamera;
using objectness::Result;
using objectness::StatusCode;

Result<PinholeCamera> toPinholeCamera(const sensor_msgs::CameraInfo& message) {
  // Rectified images follow P; drivers without stereo or rectification often fill K only.
  const bool has_p = message.P[0] != 0;
  PinholeCamera camera;
  camera.fx = has_p ? message.P[0] : message.K[0];
  camera.fy = has_p ? message.P[5] : message.K[4];
  camera.cx = has_p ? message.P[2] : message.K[2];
  camera.cy = has_p ? message.P[6] : message.K[5];
  if (camera.fx == 0 || camera.fy == 0) {
    return Result<PinholeCamera>::error(StatusCode::kBadCamera,
                                        "camera_info is not calibrated: the focal lengths in K and P are 0");
  }

  // The region of interest counts full-resolution pixels; 0 x 0 stands for the whole image, binning 0 for 1.
  const auto& roi = message.roi;
  const bool has_roi = roi.width != 0 && roi.height != 0;
  const auto binning_x = std::max<std::uint32_t>(1, message.binning_x);
  const auto binning_y = std::max<std::uint32_t>(1, message.binning_y);
  if (has_roi) {
    camera.cx -= roi.x_offset;
    camera.cy -= roi.y_offset;
  }
  camera.fx /= binning_x;
  camera.cx /= binning_x;
  camera.fy /= binning_y;
  camera.cy /= binning_y;
  camera.width = static_cast<int>((has_roi ? roi.width : message.width) / binning_x);
  camera.height = static_cast<int>((has_roi ? roi.height : message.height) / binning_y);

  const objectness::Status valid = objectness::validate(camera);
  if (!valid.ok()) return Result<PinholeCamera>::error(valid.code, "camera_info: " + valid.message);
  return {objectness::Status{}, camera};
}

}  // namespace objectness_segmentation

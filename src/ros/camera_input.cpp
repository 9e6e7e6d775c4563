// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {
namespace {

using objectness::CameraCalibration;
using objectness::ImageCamera;
using objectness::PinholeCamera;
using objectness::Result;
using objectness::StatusCode;

CameraCalibration toCalibration(const sensor_msgs::CameraInfo& message) {
  CameraCalibration calibration;
  calibration.width = message.width;
  calibration.height = message.height;
  calibration.distortion_model = message.distortion_model;
  calibration.D = message.D;
  std::copy(message.K.begin(), message.K.end(), calibration.K.begin());
  std::copy(message.P.begin(), message.P.end(), calibration.P.begin());
  calibration.binning_x = message.binning_x;
  calibration.binning_y = message.binning_y;
  calibration.roi = {message.roi.x_offset, message.roi.y_offset, message.roi.width, message.roi.height};
  return calibration;
}

/// What the core makes of the message; its reasons say what they are about.
template <class Camera>
Result<Camera> convert(const sensor_msgs::CameraInfo& message, Result<Camera> (*camera_of)(const CameraCalibration&)) {
  const bool has_p = message.P[0] != 0;
  if ((has_p ? message.P[0] : message.K[0]) == 0 || (has_p ? message.P[5] : message.K[4]) == 0) {
    return Result<Camera>::error(StatusCode::kBadCamera,
                                 "camera_info is not calibrated: the focal lengths in K and P are 0");
  }
  Result<Camera> camera = camera_of(toCalibration(message));
  if (!camera.ok()) camera.status.message = "camera_info: " + camera.status.message;
  return camera;
}

}  // namespace

Result<PinholeCamera> toPinholeCamera(const sensor_msgs::CameraInfo& message) {
  return convert(message, objectness::pinholeCamera);
}

Result<ImageCamera> toImageCamera(const sensor_msgs::CameraInfo& message) {
  return convert(message, objectness::imageCamera);
}

}  // namespace objectness_segmentation

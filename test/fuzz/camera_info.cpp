// SPDX-License-Identifier: BSD-3-Clause
// A CameraInfo of any values.
#include <cmath>

#include "frame_promises.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace objectness_fuzz;
  Bytes bytes(data, size);
  sensor_msgs::CameraInfo message;
  message.width = bytes.take<std::uint32_t>();
  message.height = bytes.take<std::uint32_t>();
  message.binning_x = bytes.take<std::uint32_t>();
  message.binning_y = bytes.take<std::uint32_t>();
  message.roi.x_offset = bytes.take<std::uint32_t>();
  message.roi.y_offset = bytes.take<std::uint32_t>();
  message.roi.width = bytes.take<std::uint32_t>();
  message.roi.height = bytes.take<std::uint32_t>();
  message.roi.do_rectify = bytes.take<std::uint8_t>() & 1;
  message.distortion_model = bytes.part();
  message.D.resize(bytes.take<std::uint8_t>() % 9);
  for (double& value : message.D) value = bytes.take<double>();
  for (double& value : message.K) value = bytes.take<double>();
  for (double& value : message.P) value = bytes.take<double>();

  const auto camera = objectness_segmentation::toPinholeCamera(message);
  requireReason(camera.status);
  const auto image_camera = objectness_segmentation::toImageCamera(message);
  requireReason(image_camera.status);
  require(camera.ok() || !image_camera.ok(), "the camera of an image is a camera");
  if (!camera.ok()) return 0;
  require(objectness::validate(camera.value).ok(), "a camera that was taken is valid");
  const Eigen::Vector3d ray = camera.value.ray(camera.value.width - 1, camera.value.height - 1);
  require(!std::isnan(ray.sum()), "rays are numbers");
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// A PointCloud2 of any layout, sizes and data: converted and made a frame of, with and without a camera.
#include "frame_promises.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

namespace {

sensor_msgs::PointCloud2 readMessage(objectness_fuzz::Bytes& bytes) {
  static const char* const kNames[] = {"x", "y", "z", "rgb", "rgba", "intensity", ""};
  sensor_msgs::PointCloud2 message;
  message.width = bytes.take<std::uint32_t>();
  message.height = bytes.take<std::uint32_t>();
  message.point_step = bytes.take<std::uint32_t>();
  message.row_step = bytes.take<std::uint32_t>();
  message.is_bigendian = bytes.take<std::uint8_t>();
  message.fields.resize(bytes.take<std::uint8_t>() % 8);
  for (sensor_msgs::PointField& field : message.fields) {
    field.name = kNames[bytes.take<std::uint8_t>() % 7];
    field.offset = bytes.take<std::uint32_t>();
    field.datatype = bytes.take<std::uint8_t>();
    field.count = bytes.take<std::uint8_t>();
  }
  return message;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace objectness_fuzz;
  Bytes bytes(data, size);
  sensor_msgs::PointCloud2 message = readMessage(bytes);
  objectness::PinholeCamera camera;
  camera.fx = camera.fy = bytes.take<float>();
  // Few points on a large image are a valid frame, but one that takes a sanitized program a second.
  camera.width = bytes.take<std::uint16_t>() % 1024;
  camera.height = bytes.take<std::uint16_t>() % 1024;
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  const std::string rest = bytes.rest();
  message.data.assign(rest.begin(), rest.end());

  const auto cloud = objectness_segmentation::toRawCloud(message);
  requireReason(cloud.status);
  if (!cloud.ok()) return 0;
  require(cloud.value.points.size() == std::size_t{message.width} * message.height, "a cloud has all its points");
  require(cloud.value.colors.empty() || cloud.value.colors.size() == cloud.value.points.size(), "a colour a point");
  const objectness::InputConfig config;
  requireFrame(objectness::makeFrame(cloud.value, std::nullopt, config), config);
  requireFrame(objectness::makeFrame(cloud.value, camera, config), config);
  return 0;
}

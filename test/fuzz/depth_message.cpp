// SPDX-License-Identifier: BSD-3-Clause
// A depth image and a picture of any encoding, sizes and data: converted and made a frame of.
#include <iterator>

#include "frame_promises.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

namespace {

sensor_msgs::Image readMessage(objectness_fuzz::Bytes& bytes) {
  static const char* const kEncodings[] = {"32FC1", "16UC1",  "mono16", "rgb8",       "bgra8",
                                           "mono8", "yuv422", "64FC4",  "bayer_rggb8"};
  sensor_msgs::Image message;
  message.width = bytes.take<std::uint32_t>();
  message.height = bytes.take<std::uint32_t>();
  message.step = bytes.take<std::uint32_t>();
  message.is_bigendian = bytes.take<std::uint8_t>();
  const std::size_t encoding = bytes.take<std::uint8_t>();
  message.encoding = encoding < std::size(kEncodings) ? kEncodings[encoding] : bytes.part();
  const std::string data = bytes.part();
  message.data.assign(data.begin(), data.end());
  return message;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace objectness_fuzz;
  Bytes bytes(data, size);
  const sensor_msgs::Image depth_message = readMessage(bytes), color_message = readMessage(bytes);
  const auto depth = objectness_segmentation::toDepthImage(depth_message);
  const auto color = objectness_segmentation::toColorImage(color_message);
  requireReason(depth.status);
  requireReason(color.status);
  require(!color.ok() || color.value.type() == CV_8UC3, "a picture is BGR");
  if (!depth.ok()) return 0;
  const objectness::PinholeCamera camera{
      10, 10, 0.5 * (depth.value.cols - 1), 0.5 * (depth.value.rows - 1), depth.value.cols, depth.value.rows};
  const objectness::InputConfig config;
  requireFrame(objectness::makeFrame(depth.value, {}, camera, config), config);
  if (color.ok()) requireFrame(objectness::makeFrame(depth.value, color.value, camera, config), config);
  return 0;
}

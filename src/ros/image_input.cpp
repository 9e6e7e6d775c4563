// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>

#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {
namespace {

namespace encodings = sensor_msgs::image_encodings;
using objectness::Result;
using objectness::StatusCode;

Result<cv::Mat> bad(const std::string& message) { return Result<cv::Mat>::error(StatusCode::kBadInput, message); }

std::string sizeText(const sensor_msgs::Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

/// The bytes from one row to the next; some drivers leave them out where rows follow one another.
std::uint64_t stepOf(const sensor_msgs::Image& image, std::uint64_t pixel_bytes) {
  return image.step != 0 ? image.step : image.width * pixel_bytes;
}

/// 64-bit sums: a hostile message must not pass by overflow.
std::string contradiction(const sensor_msgs::Image& image, std::uint64_t pixel_bytes) {
  const std::uint64_t step = stepOf(image, pixel_bytes), height = image.height, row = image.width * pixel_bytes;
  if (image.width == 0 || height == 0) return "is empty (" + sizeText(image) + ")";
  if (step < row) {
    return "has a step of " + std::to_string(step) + " bytes, but a row of " + std::to_string(image.width) +
           " pixels takes " + std::to_string(row);
  }
  if (row > image.data.size() || image.data.size() != step * height) {
    return "says " + sizeText(image) + " with a step of " + std::to_string(step) + " bytes, but carries " +
           std::to_string(image.data.size()) + " bytes";
  }
  return "";
}

/// Turns the bytes of each value round.
void swapBytes(std::uint8_t* bytes, std::size_t count, std::size_t value_bytes) {
  for (std::size_t i = 0; i + value_bytes <= count; i += value_bytes) {
    std::reverse(bytes + i, bytes + i + value_bytes);
  }
}

constexpr bool kBigEndianHost = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/// A picture as cv_bridge takes it: with a step, in the byte order of this machine.
sensor_msgs::Image plainPicture(const sensor_msgs::Image& message, std::uint64_t pixel_bytes, int value_bits) {
  sensor_msgs::Image plain = message;
  plain.step = static_cast<std::uint32_t>(stepOf(message, pixel_bytes));
  if (value_bits > 8 && (message.is_bigendian != 0) != kBigEndianHost) {
    const std::size_t row = message.width * pixel_bytes;
    for (std::size_t v = 0; v < message.height; ++v) {
      swapBytes(plain.data.data() + v * plain.step, row, static_cast<std::size_t>(value_bits) / 8);
    }
    plain.is_bigendian = kBigEndianHost;
  }
  return plain;
}

}  // namespace

Result<cv::Mat> toDepthImage(const sensor_msgs::Image& message) {
  const bool metres = message.encoding == encodings::TYPE_32FC1;
  if (!metres && message.encoding != encodings::TYPE_16UC1 && message.encoding != encodings::MONO16) {
    return bad("depth image is encoded as '" + message.encoding +
               "': 16UC1 (millimetres) or 32FC1 (metres) is needed; is depth remapped to the depth image?");
  }
  const std::uint64_t pixel_bytes = metres ? 4 : 2;
  const std::string problem = contradiction(message, pixel_bytes);
  if (!problem.empty()) return bad("depth image " + problem);
  try {
    cv::Mat depth(static_cast<int>(message.height), static_cast<int>(message.width), metres ? CV_32FC1 : CV_16UC1);
    const std::uint64_t step = stepOf(message, pixel_bytes), row = message.width * pixel_bytes;
    for (int v = 0; v < depth.rows; ++v) {
      std::memcpy(depth.ptr(v), message.data.data() + static_cast<std::uint64_t>(v) * step, row);
      if ((message.is_bigendian != 0) != kBigEndianHost) swapBytes(depth.ptr(v), row, pixel_bytes);
    }
    return {{}, depth};
  } catch (const std::exception& e) {
    return bad(std::string("depth image: ") + e.what());
  }
}

cv::Mat thinned(const cv::Mat& image, int step) {
  if (step == 1) return image;
  cv::Mat thin((image.rows + step - 1) / step, (image.cols + step - 1) / step, image.type());
  const std::size_t pixel = image.elemSize();
  for (int v = 0; v < thin.rows; ++v) {
    for (int u = 0; u < thin.cols; ++u) {
      std::memcpy(thin.ptr(v) + u * pixel, image.ptr(v * step) + static_cast<std::size_t>(u) * step * pixel, pixel);
    }
  }
  return thin;
}

Result<cv::Mat> toColorImage(const sensor_msgs::Image& message) {
  if (message.width == 0 || message.height == 0) return bad("rgb image is empty (" + sizeText(message) + ")");
  try {
    // These throw for encodings that are not known.
    const int value_bits = encodings::bitDepth(message.encoding), channels = encodings::numChannels(message.encoding);
    const auto pixel_bytes = static_cast<std::uint64_t>(channels) * static_cast<std::uint64_t>(value_bits) / 8;
    const std::string problem = contradiction(message, pixel_bytes);
    if (!problem.empty()) return bad("rgb image " + problem);
    return {{}, cv_bridge::toCvCopy(plainPicture(message, pixel_bytes, value_bits), encodings::BGR8)->image};
  } catch (const std::exception& e) {
    return bad("rgb image of encoding '" + message.encoding + "': " + e.what());
  }
}

}  // namespace objectness_segmentation

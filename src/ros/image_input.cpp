// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

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

/// 64-bit sums: a hostile message must not pass by overflow.
std::string contradiction(const sensor_msgs::Image& image, std::uint64_t pixel_bytes) {
  const std::uint64_t step = image.step, height = image.height, row = image.width * pixel_bytes;
  if (image.width == 0 || height == 0) return "is empty (" + sizeText(image) + ")";
  if (step < row) {
    return "has a step of " + std::to_string(step) + " bytes, but a row of " + std::to_string(image.width) +
           " pixels takes " + std::to_string(row);
  }
  if (image.data.size() != step * height) {
    return "says " + sizeText(image) + " with a step of " + std::to_string(step) + " bytes, but carries " +
           std::to_string(image.data.size()) + " bytes";
  }
  return "";
}

}  // namespace

Result<cv::Mat> toDepthImage(const sensor_msgs::Image& message) {
  const bool metres = message.encoding == encodings::TYPE_32FC1;
  if (!metres && message.encoding != encodings::TYPE_16UC1 && message.encoding != encodings::MONO16) {
    return bad("depth image is encoded as '" + message.encoding +
               "': 16UC1 (millimetres) or 32FC1 (metres) is needed; is depth remapped to the depth image?");
  }
  const std::string problem = contradiction(message, metres ? 4 : 2);
  if (!problem.empty()) return bad("depth image " + problem);
  try {
    return {{}, cv_bridge::toCvCopy(message, metres ? encodings::TYPE_32FC1 : encodings::TYPE_16UC1)->image};
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

objectness::PinholeCamera thinned(objectness::PinholeCamera camera, int step) {
  camera.fx /= step;
  camera.fy /= step;
  camera.cx /= step;
  camera.cy /= step;
  camera.width = (camera.width + step - 1) / step;
  camera.height = (camera.height + step - 1) / step;
  return camera;
}

Result<cv::Mat> toColorImage(const sensor_msgs::Image& message) {
  const std::string problem = contradiction(message, 1);
  if (!problem.empty()) return bad("rgb image " + problem);
  try {
    return {{}, cv_bridge::toCvCopy(message, encodings::BGR8)->image};
  } catch (const std::exception& e) {
    return bad("rgb image of encoding '" + message.encoding + "': " + e.what());
  }
}

}  // namespace objectness_segmentation

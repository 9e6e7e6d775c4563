// SPDX-License-Identifier: BSD-3-Clause
#include "ros/compressed_images.hpp"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>

namespace objectness_segmentation {
namespace {

namespace encodings = sensor_msgs::image_encodings;
using objectness::StatusCode;
using Decoded = objectness::Result<sensor_msgs::ImageConstPtr>;

/// compressed_depth_image_transport's ConfigHeader, before the PNG; little endian.
struct DepthHeader {
  std::int32_t format;
  float a, b;
};

Decoded bad(const std::string& what, const sensor_msgs::CompressedImage& message) {
  return Decoded::error(StatusCode::kBadInput, "is a compressed image of the format '" + message.format + "' " + what);
}

/// Empty when it cannot be decoded.
cv::Mat decoded(const std::uint8_t* bytes, std::size_t size, int flags) {
  if (size == 0 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return {};
  const cv::Mat coded(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(bytes));
  try {
    return cv::imdecode(coded, flags);
  } catch (const cv::Exception&) {
    return {};
  }
}

sensor_msgs::ImageConstPtr toMessage(const cv::Mat& image, const char* encoding, const std_msgs::Header& header) {
  return cv_bridge::CvImage(header, encoding, image).toImageMsg();
}

cv::Mat_<float> fromInverse(const cv::Mat_<ushort>& inverse, const DepthHeader& header) {
  cv::Mat_<float> depth(inverse.size());
  for (int v = 0; v < inverse.rows; ++v) {
    for (int u = 0; u < inverse.cols; ++u) {
      const ushort value = inverse(v, u);
      depth(v, u) = value ? header.a / (static_cast<float>(value) - header.b) : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return depth;
}

}  // namespace

bool isCompressedDepth(const sensor_msgs::CompressedImage& message) {
  return message.format.find("compressedDepth") != std::string::npos;
}

Decoded decodeDepth(const sensor_msgs::CompressedImage& message) {
  if (message.format.find("rvl") != std::string::npos) {
    return bad("that is not read: record it as png or raw", message);
  }
  if (message.data.size() <= sizeof(DepthHeader)) return bad("that is cut off", message);
  DepthHeader header;
  std::memcpy(&header, message.data.data(), sizeof(header));
  const cv::Mat stored =
      decoded(message.data.data() + sizeof(header), message.data.size() - sizeof(header), cv::IMREAD_UNCHANGED);
  if (stored.type() != CV_16UC1 || stored.empty()) return bad("that holds no 16-bit PNG", message);
  if (message.format.find(encodings::TYPE_32FC1) == std::string::npos) {
    return {{}, toMessage(stored, encodings::TYPE_16UC1.c_str(), message.header)};
  }
  return {{}, toMessage(fromInverse(stored, header), encodings::TYPE_32FC1.c_str(), message.header)};
}

Decoded decodeColor(const sensor_msgs::CompressedImage& message) {
  const cv::Mat picture = decoded(message.data.data(), message.data.size(), cv::IMREAD_COLOR);
  if (picture.empty()) return bad("that holds no JPEG or PNG", message);
  return {{}, toMessage(picture, encodings::BGR8.c_str(), message.header)};
}

}  // namespace objectness_segmentation

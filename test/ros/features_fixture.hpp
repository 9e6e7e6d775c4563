// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/SegmentOnce.h>
#include <sensor_msgs/Image.h>

#include <cmath>
#include <cstring>
#include <future>
#include <string>

#include "nodelet_fixture.hpp"

namespace objectness_test {

using objectness_segmentation::SegmentOnce;
using sensor_msgs::Image;

class Features : public SegmentObjects {
 protected:
  /// The service of a nodelet, called from another thread.
  static std::future<SegmentOnce::Response> request(const std::string& node, double timeout_s) {
    return std::async(std::launch::async, [=] {
      SegmentOnce call;
      call.request.timeout = static_cast<float>(timeout_s);
      if (!ros::service::call(node + "/segment", call)) call.response.result.message = "the call failed";
      return call.response;
    });
  }
  template <class T>
  static bool isReady(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }

  std::string points() const { return cloud_publisher_.getTopic(); }
  std::string cameraInfo() const { return camera_publisher_.getTopic(); }

  /// What a stamp-and-frame header becomes when the clock is this process's.
  static std_msgs::Header headerNow(double ahead_s = 0) {
    std_msgs::Header header;
    header.stamp = ros::Time(ros::Time::now().toSec() + ahead_s);
    header.frame_id = "some_camera/optical_frame";
    return header;
  }

  Image depthImage(const char* encoding) const {
    Image image;
    image.header = nextHeader();
    image.width = static_cast<std::uint32_t>(frame_.width());
    image.height = static_cast<std::uint32_t>(frame_.height());
    image.encoding = encoding;
    const bool metres = image.encoding == "32FC1";
    image.step = image.width * (metres ? 4 : 2);
    image.data.resize(std::size_t{image.step} * image.height);
    for (int i = 0; i < frame_.size(); ++i) {
      const float z = frame_.points[i].z();
      const auto mm = static_cast<std::uint16_t>(std::isnan(z) ? 0 : std::lround(1000 * z));
      std::memcpy(image.data.data() + std::size_t(i) * (metres ? 4 : 2), metres ? static_cast<const void*>(&z) : &mm,
                  metres ? 4 : 2);
    }
    return image;
  }
};

}  // namespace objectness_test

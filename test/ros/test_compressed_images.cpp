// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/compressed_messages.hpp"
#include "fixtures/ros_messages.hpp"
#include "ros/compressed_images.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

sensor_msgs::Image depthInMetres(const cv::Mat_<float>& depth) {
  return *cv_bridge::CvImage(makeHeader(3), "32FC1", depth).toImageMsg();
}

TEST(CompressedImages, DepthInMetresComesBackWithinItsSteps) {
  cv::Mat_<float> depth(4, 50);
  for (int i = 0; i < 200; ++i) depth(i / 50, i % 50) = 0.3f + 0.02f * static_cast<float>(i);
  depth(2, 7) = std::nanf("");
  const sensor_msgs::CompressedImage message = compressedDepth(depthInMetres(depth));
  ASSERT_TRUE(isCompressedDepth(message));
  const auto decoded = decodeDepth(message);
  ASSERT_TRUE(decoded.ok()) << decoded.status.message;
  EXPECT_EQ(decoded.value->encoding, "32FC1");
  EXPECT_EQ(decoded.value->header.stamp, ros::Time(3));
  const cv::Mat_<float> read = cv_bridge::toCvShare(decoded.value)->image;
  for (int i = 0; i < 200; ++i) {
    const float z = depth(i / 50, i % 50);
    if (std::isnan(z)) {
      EXPECT_TRUE(std::isnan(read(i / 50, i % 50)));
    } else {
      // A step of the inverse depth, of which a = 10100 are a 1/m.
      EXPECT_NEAR(read(i / 50, i % 50), z, z * z / 10100 + 1e-4f) << z;
    }
  }
}

TEST(CompressedImages, DepthInMillimetresIsAsItWas) {
  const cv::Mat_<ushort> depth = (cv::Mat_<ushort>(2, 3) << 0, 400, 65535, 1, 999, 1000);
  const auto decoded = decodeDepth(compressedMillimetres(depth, makeHeader(1)));
  ASSERT_TRUE(decoded.ok()) << decoded.status.message;
  EXPECT_EQ(decoded.value->encoding, "16UC1");
  EXPECT_EQ(cv::countNonZero(cv_bridge::toCvShare(decoded.value)->image != depth), 0);
}

TEST(CompressedImages, PicturesAreBgr) {
  const cv::Mat_<cv::Vec3b> picture(5, 6, cv::Vec3b(10, 120, 230));
  sensor_msgs::CompressedImage message;
  message.format = "bgr8; png compressed bgr8";
  cv::imencode(".png", picture, message.data);
  EXPECT_FALSE(isCompressedDepth(message));
  const auto decoded = decodeColor(message);
  ASSERT_TRUE(decoded.ok()) << decoded.status.message;
  EXPECT_EQ(decoded.value->encoding, "bgr8");
  EXPECT_EQ((cv_bridge::toCvShare(decoded.value)->image.at<cv::Vec3b>(4, 5)), picture(4, 5));
}

TEST(CompressedImages, WhatCannotBeDecodedIsNamed) {
  const sensor_msgs::CompressedImage good = compressedDepth(depthInMetres(cv::Mat_<float>(3, 3, 1.f)));
  const auto problem = [&](auto change) {
    sensor_msgs::CompressedImage message = good;
    change(message);
    const auto decoded = decodeDepth(message);
    EXPECT_FALSE(decoded.ok());
    return decoded.status.message;
  };
  const auto contains = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(contains(problem([](auto& m) { m.format = "16UC1; compressedDepth rvl"; }), "record it as png or raw"));
  EXPECT_TRUE(contains(problem([](auto& m) { m.data.resize(12); }), "that is cut off"));
  EXPECT_TRUE(contains(problem([](auto& m) { m.data.clear(); }), "that is cut off"));
  EXPECT_TRUE(contains(problem([](auto& m) { m.data.resize(30); }), "that holds no 16-bit PNG"));
  EXPECT_TRUE(contains(problem([](auto& m) { std::fill(m.data.begin() + 12, m.data.end(), 7); }), "no 16-bit PNG"));
  sensor_msgs::CompressedImage picture;
  picture.format = "jpeg";
  EXPECT_TRUE(contains(decodeColor(picture).status.message, "'jpeg' that holds no JPEG or PNG"));
  picture.data.assign(40, 200);
  EXPECT_FALSE(decodeColor(picture).ok());
}

}  // namespace

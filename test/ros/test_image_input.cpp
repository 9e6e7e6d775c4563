// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fixtures/depth_message.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::StatusCode;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

const std::vector<std::uint16_t> kMillimetres = {0, 500, 1000, 65535, 1234, 7};
const std::vector<float> kMetres = {kNan, 0.5F, kInf, -kInf, 0.0F, 1.25F};

TEST(DepthInput, ReadsMillimetresAndMetres) {
  for (const std::uint32_t padding : {0u, 6u}) {
    for (const char* encoding : {"16UC1", "mono16"}) {
      const auto depth = toDepthImage(makeDepth(kMillimetres, 3, encoding, padding));
      ASSERT_TRUE(depth.ok()) << depth.status.message;
      ASSERT_EQ(depth.value.type(), CV_16UC1);
      for (int i = 0; i < 6; ++i) EXPECT_EQ(depth.value.at<ushort>(i / 3, i % 3), kMillimetres[i]) << i;
    }
  }
  const auto depth = toDepthImage(makeDepth(kMetres, 3, "32FC1"));
  ASSERT_TRUE(depth.ok()) << depth.status.message;
  ASSERT_EQ(depth.value.type(), CV_32FC1);
  EXPECT_EQ(depth.value.at<float>(0, 1), 0.5F);
  EXPECT_EQ(depth.value.at<float>(1, 2), 1.25F);
}

/// As a machine of the other byte order sends it.
template <class Value>
sensor_msgs::Image bigEndian(sensor_msgs::Image image) {
  for (std::uint32_t v = 0; v < image.height; ++v) {
    std::uint8_t* row = image.data.data() + std::size_t{v} * image.step;
    for (std::uint32_t u = 0; u < image.width; ++u) {
      std::reverse(row + u * sizeof(Value), row + (u + 1) * sizeof(Value));
    }
  }
  image.is_bigendian = true;
  return image;
}

TEST(DepthInput, TurnsTheBytesOfABigEndianImageRound) {
  for (const std::uint32_t padding : {0u, 3u, 6u}) {
    for (const char* encoding : {"16UC1", "mono16"}) {
      const auto depth = toDepthImage(bigEndian<std::uint16_t>(makeDepth(kMillimetres, 3, encoding, padding)));
      ASSERT_TRUE(depth.ok()) << depth.status.message;
      for (int i = 0; i < 6; ++i) EXPECT_EQ(depth.value.at<ushort>(i / 3, i % 3), kMillimetres[i]) << padding;
    }
    const auto depth = toDepthImage(bigEndian<float>(makeDepth(kMetres, 3, "32FC1", padding)));
    ASSERT_TRUE(depth.ok()) << depth.status.message;
    EXPECT_EQ(depth.value.at<float>(0, 1), 0.5F);
    EXPECT_EQ(depth.value.at<float>(1, 2), 1.25F);
  }
}

TEST(DepthInput, RowsThatFollowOneAnotherNeedNoStep) {
  sensor_msgs::Image image = makeDepth(kMillimetres, 3, "16UC1");
  image.step = 0;
  const auto depth = toDepthImage(image);
  ASSERT_TRUE(depth.ok()) << depth.status.message;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(depth.value.at<ushort>(i / 3, i % 3), kMillimetres[i]) << i;
}

void expectBad(const sensor_msgs::Image& image, const std::string& word) {
  const auto depth = toDepthImage(image);
  EXPECT_EQ(depth.status.code, StatusCode::kBadInput) << word;
  EXPECT_NE(depth.status.message.find(word), std::string::npos) << depth.status.message;
}

TEST(DepthInput, RefusesWhatIsNoDepthImage) {
  const sensor_msgs::Image good = makeDepth(kMillimetres, 3, "16UC1");
  sensor_msgs::Image image = good;
  for (const char* encoding : {"rgb8", "", "8UC1", "64FC1", "nonsense"}) {
    image.encoding = encoding;
    expectBad(image, "16UC1 (millimetres) or 32FC1 (metres)");
  }
  image = good;
  image.step = 5;
  expectBad(image, "step");
  image = good;
  image.data.pop_back();
  expectBad(image, "carries");
  image.width = image.height = image.step = 0xFFFFFFFF;
  expectBad(image, "step");
  image.width = 0x10000000;
  expectBad(image, "carries");
  image.width = 0;
  expectBad(image, "empty");
  expectBad(sensor_msgs::Image(), "encoded");
  image = good;
  image.step = 0;
  image.data.pop_back();
  expectBad(image, "carries");
  image.width = image.height = 0xFFFFFFFF;
  expectBad(image, "carries");
}

TEST(ColorInput, EveryByteOrderAndNoStep) {
  sensor_msgs::Image image;
  image.encoding = "mono16";
  image.width = 2;
  image.height = 1;
  image.is_bigendian = true;
  image.data = {0xFF, 0x00, 0x00, 0x00};
  const auto color = toColorImage(image);
  ASSERT_TRUE(color.ok()) << color.status.message;
  EXPECT_NEAR(color.value.at<cv::Vec3b>(0, 0)[1], 254, 1);
  EXPECT_EQ(color.value.at<cv::Vec3b>(0, 1), cv::Vec3b(0, 0, 0));
}

}  // namespace

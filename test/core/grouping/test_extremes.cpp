// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>
#include <random>

#include "grouping/extremes.hpp"

using namespace objectness;

namespace {

std::vector<float> randomValues(std::mt19937& random, int count, int kinds) {
  std::vector<float> values(count);
  for (float& value : values) value = 0.001f * static_cast<float>(random() % kinds) - 0.2f;
  return values;
}

}  // namespace

TEST(Extremes, ValuesAreThoseOfSorting) {
  std::mt19937 random(3);
  std::vector<float> scratch;
  for (int round = 0; round < 600; ++round) {
    const int count = 1 + static_cast<int>(random() % (round % 3 ? 3000 : 40));
    std::vector<float> values = randomValues(random, count, round % 2 ? 7 : 1000000);
    if (round % 5 == 0) std::sort(values.begin(), values.end());
    // All that the sample sees lies at one end.
    if (round % 5 == 1) {
      for (std::size_t i = 0; i < values.size(); i += 16) values[i] = round % 10 == 1 ? -9.f : 9.f;
    }
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const std::size_t k : {std::size_t(0), values.size() / 100, values.size() / 2, values.size() - 1}) {
      EXPECT_EQ(smallestButFew(k, values, scratch), sorted[k]) << count << " " << k;
      EXPECT_EQ(largestButFew(k, values, scratch), sorted[sorted.size() - 1 - k]) << count << " " << k;
    }
  }
}

TEST(Extremes, OuterPointsHaveTheSameHullAndRectangle) {
  std::mt19937 random(4);
  std::size_t left = 0, all = 0;
  for (int round = 0; round < 400; ++round) {
    const int count = 1 + static_cast<int>(random() % (round % 4 ? 2500 : 12));
    const float yaw = 0.01f * static_cast<float>(random() % 314), ratio = 0.1f * static_cast<float>(random() % 10);
    std::vector<cv::Point2f> points;
    for (int i = 0; i < count; ++i) {
      const float x = 2e-4f * static_cast<float>(random() % 1000) - 0.1f, v = static_cast<float>(random() % 1000);
      // A filled rectangle, its outline, a disk.
      const float y = round % 3 == 0   ? ratio * (2e-4f * v - 0.1f)
                      : round % 3 == 1 ? ratio * (random() % 2 ? 0.1f : -0.1f)
                                       : std::sqrt(std::max(0.f, 0.01f - x * x)) * (0.002f * v - 1);
      points.emplace_back(0.5f + std::cos(yaw) * x - std::sin(yaw) * y, std::sin(yaw) * x + std::cos(yaw) * y - 0.3f);
    }
    const std::vector<cv::Point2f> outer = outerPoints(points);
    all += points.size();
    left += outer.size();
    std::vector<cv::Point2f> hull, hull_of_outer;
    cv::convexHull(points, hull);
    cv::convexHull(outer, hull_of_outer);
    ASSERT_EQ(hull, hull_of_outer) << round;
    const cv::RotatedRect a = cv::minAreaRect(points), b = cv::minAreaRect(outer);
    EXPECT_EQ(std::memcmp(&a, &b, sizeof(a)), 0) << round;
  }
  EXPECT_LT(left, all * 2 / 3);
}

TEST(Extremes, PointsInOnePlaceStay) {
  EXPECT_TRUE(outerPoints({}).empty());
  const std::vector<cv::Point2f> twice(2, cv::Point2f(0.1f, 0.2f));
  EXPECT_EQ(outerPoints(twice), twice);
  const std::vector<cv::Point2f> line{{0, 0}, {0.1f, 0.1f}, {0.2f, 0.2f}};
  EXPECT_EQ(outerPoints(line), line);
}

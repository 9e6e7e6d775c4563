// SPDX-License-Identifier: BSD-3-Clause
// Connected parts by runs and by bands of rows beside flooding from pixel to pixel.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "fixtures/random_frame.hpp"
#include "scene/connected_components_2d.hpp"
#include "scene/connected_components_3d.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// 0 = not in the mask, 1.. = part, in the order of first pixels. joined(pixel, other): whether neighbours belong
/// together.
cv::Mat_<int> flooded(const cv::Mat_<uchar>& mask, bool diagonal, const std::function<bool(int, int)>& joined) {
  cv::Mat_<int> label(mask.size(), 0);
  int count = 0;
  for (int start = 0; start < static_cast<int>(mask.total()); ++start) {
    if (!mask(start) || label(start)) continue;
    label(start) = ++count;
    std::vector<int> open{start};
    while (!open.empty()) {
      const int pixel = open.back(), u = pixel % mask.cols, v = pixel / mask.cols;
      open.pop_back();
      for (int y = std::max(0, v - 1); y <= std::min(mask.rows - 1, v + 1); ++y) {
        for (int x = std::max(0, u - 1); x <= std::min(mask.cols - 1, u + 1); ++x) {
          const int other = y * mask.cols + x;
          if (!mask(other) || label(other) || (!diagonal && x != u && y != v) || !joined(pixel, other)) continue;
          label(other) = count;
          open.push_back(other);
        }
      }
    }
  }
  return label;
}

cv::Mat_<uchar> randomMask(int width, int height, double share, unsigned seed) {
  std::mt19937 random(seed);
  cv::Mat_<uchar> mask(height, width);
  for (uchar& pixel : mask) {
    pixel = std::uniform_real_distribution<double>(0, 1)(random) < share ? uchar(1 + random() % 255) : 0;
  }
  return mask;
}

}  // namespace

TEST(MaskComponents, AreThoseOfFlooding) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 20), cv::Size(20, 1), cv::Size(8, 8), cv::Size(67, 41)}) {
    for (const double share : {0.0, 0.1, 0.4, 0.6, 0.95, 1.0}) {
      const cv::Mat_<uchar> mask = randomMask(size.width, size.height, share, static_cast<unsigned>(100 * share));
      for (const bool diagonal : {false, true}) {
        const cv::Mat_<int> expected = flooded(mask, diagonal, [](int, int) { return true; });
        const MaskComponents parts = findComponents(mask, diagonal ? Neighbours::kEight : Neighbours::kFour);
        cv::Mat_<int> label(size, 0);
        for (const objectness::Run& run : parts.runs) {
          ASSERT_LT(run.part, parts.count);
          for (int u = run.first; u < run.last; ++u) label(run.row, u) = run.part + 1;
        }
        ASSERT_EQ(cv::norm(label, expected, cv::NORM_INF), 0) << size << " " << share << " " << diagonal;
      }
    }
  }
}

TEST(ConnectedPoints, AreThoseOfFloodingWithAnyNumberOfThreads) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Frame frame = randomFrame(90, 200, seed);
    cv::Mat_<uchar> mask = randomMask(90, 200, 0.9, seed);
    for (int i = 0; i < frame.size(); ++i) mask(i) = frame.points[i].z() > 0 ? mask(i) : uchar(0);
    const Gap gap{0.004f, 0.003f, 2, {}};
    const cv::Mat_<int> expected = flooded(mask, true, [&](int pixel, int other) {
      return (frame.points[pixel] - frame.points[other]).norm() <= gap.at(frame.points[std::max(pixel, other)].z());
    });
    for (const int threads : {1, 3}) {
      int count = 0;
      const cv::Mat_<int> label = connectPoints(frame.points, mask, gap, count, threads);
      double most = 0;
      cv::minMaxLoc(expected, nullptr, &most);
      EXPECT_GT(most, 3);
      EXPECT_EQ(count, most);
      EXPECT_EQ(cv::norm(label, expected, cv::NORM_INF), 0) << seed;
    }
  }
}

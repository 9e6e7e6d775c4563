// SPDX-License-Identifier: BSD-3-Clause
// Pieces of surface beside the same watershed written down plainly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "cues/crease.hpp"
#include "cues/radix_order.hpp"
#include "cues/watershed.hpp"
#include "fixtures/random_frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// Pixels join one after the other, the farthest from a cut first; a piece is the list of its pixels.
class PlainGrower {
 public:
  PlainGrower(const Frame& frame, const Normals& normals, const DepthNoise& noise, const SuperpixelsConfig& config)
      : frame_(frame), normals_(normals), noise_(noise), config_(config) {}

  cv::Mat_<int> run(const cv::Mat_<uchar>& smooth) {
    cv::Mat_<float> room;
    cv::distanceTransform(smooth, room, cv::DIST_L2, 3);
    std::vector<int> order;
    for (int i = 0; i < frame_.size(); ++i) {
      if (smooth(i)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return room(a) > room(b); });
    cv::Mat_<int> name(smooth.size(), -1);
    pieces_.assign(frame_.size(), {});
    rooms_.assign(frame_.size(), 0);
    for (const int pixel : order) {
      name(pixel) = pixel;
      pieces_[pixel] = {pixel};
      rooms_[pixel] = room(pixel);
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          const int u = pixel % smooth.cols + du, v = pixel / smooth.cols + dv, other = v * smooth.cols + u;
          if (u < 0 || v < 0 || u >= smooth.cols || v >= smooth.rows || name(other) < 0) continue;
          const int a = name(pixel), b = name(other);
          if (a != b && connected(pixel, other) && !narrow(a, b, room(pixel))) join(a, b, name);
        }
      }
    }
    for (const int pixel : order) {
      if (!largeEnough(pieces_[name(pixel)], 1)) too_small_.push_back(pixel);
    }
    for (const int pixel : too_small_) name(pixel) = -1;
    return name;
  }

 private:
  bool connected(int a, int b) const {
    if (!(normals_.normal[a].dot(normals_.normal[b]) > static_cast<float>(std::cos(config_.neighbor_deg * M_PI / 180))))
      return false;
    const double z = std::min(frame_.points[a].z(), frame_.points[b].z());
    const double step = std::abs(double(frame_.points[a].z()) - frame_.points[b].z());
    return step < 0.004 || step < std::max(kGrazingSlope * z / frame_.camera.focal(), 4.0 * noise_.sigma(z));
  }

  bool largeEnough(const std::vector<int>& piece, double times) const {
    double area = 0;
    for (const int pixel : piece) area += double(frame_.points[pixel].z()) * frame_.points[pixel].z();
    return piece.size() >= times * config_.min_pixels &&
           area / (frame_.camera.fx * frame_.camera.fy) >= times * config_.min_area_m2;
  }

  bool narrow(int a, int b, float room) const {
    return room < config_.narrow_share * std::min(rooms_[a], rooms_[b]) && largeEnough(pieces_[a], 3) &&
           largeEnough(pieces_[b], 3);
  }

  void join(int a, int b, cv::Mat_<int>& name) {
    const int to = std::min(a, b), from = std::max(a, b);
    for (const int pixel : pieces_[from]) name(pixel) = to;
    pieces_[to].insert(pieces_[to].end(), pieces_[from].begin(), pieces_[from].end());
    pieces_[from].clear();
    rooms_[to] = std::max(rooms_[to], rooms_[from]);
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const SuperpixelsConfig& config_;
  std::vector<std::vector<int>> pieces_;
  std::vector<float> rooms_;
  std::vector<int> too_small_;
};

}  // namespace

TEST(GrownPieces, AreThoseOfThePlainWatershed) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const Frame frame = randomFrame(160, 120, seed);
    NormalsConfig windows;
    windows.window_m = 0.03;
    const Normals normals = estimateNormals(frame, windows);
    cv::Mat_<uchar> smooth(frame.height(), frame.width());
    std::mt19937 random(seed);
    for (int i = 0; i < frame.size(); ++i) smooth(i) = normals.radius_px[i] >= kMinWindowPx && random() % 50 ? 255 : 0;
    smooth.colRange(0, seed == 1 ? 0 : 20) = 0;
    SuperpixelsConfig config;
    config.min_area_m2 = 1e-3;
    const cv::Mat_<int> plain = PlainGrower(frame, normals, {}, config).run(smooth);
    EXPECT_GT(cv::countNonZero(plain >= 0), 1000);
    for (const int threads : {1, 3}) {
      const cv::Mat_<int> pieces =
          growRegions(frame, connectSmooth(frame, normals, {}, smooth, config, threads), config);
      EXPECT_EQ(cv::norm(pieces, plain, cv::NORM_INF), 0) << seed;
    }
  }
}

TEST(GrownPieces, NothingGrowsFromNothing) {
  const Frame frame = randomFrame(20, 10, 1);
  const Normals normals = estimateNormals(frame, {});
  const cv::Mat_<int> pieces =
      growRegions(frame, connectSmooth(frame, normals, {}, cv::Mat_<uchar>(10, 20, uchar(0)), {}), {});
  EXPECT_EQ(cv::countNonZero(pieces + 1), 0);
}

TEST(RadixOrder, IsAStableSort) {
  std::mt19937 random(1);
  for (const int count : {0, 1, 2, 1000, 100000}) {
    std::vector<float> values(count);
    for (float& value : values) value = static_cast<float>(random() % 5000) * (random() % 3 ? 0.37f : 1e-6f);
    std::vector<int> expected(count);
    for (int i = 0; i < count; ++i) expected[i] = i;
    std::stable_sort(expected.begin(), expected.end(), [&](int a, int b) { return values[a] > values[b]; });
    EXPECT_EQ(descendingOrder(values), expected);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Bends and steps compared run by run beside the same pixel by pixel: equal to the last bit.
#include <gtest/gtest.h>

#include <cstring>

#include "cues/crease.hpp"
#include "cues/side_runs.hpp"
#include "fixtures/random_frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

struct View {
  Frame frame;
  Normals normals;
  cv::Mat_<uchar> where;

  explicit View(unsigned seed) : frame(randomFrame(200, 150, seed)) {
    NormalsConfig config;
    config.window_m = 0.03;
    normals = estimateNormals(frame, config);
    where = cv::Mat_<uchar>(150, 200, uchar(255));
    where(cv::Rect(30, 40, 50, 20)) = 0;
    for (int i = 0; i < frame.size(); i += 97) where(i) = 0;
  }
};

template <class Value>
bool sameBits(const cv::Mat_<Value>& a, const cv::Mat_<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * sizeof(Value)) == 0;
}

BendMap plainBends(const View& view) {
  const cv::Size size = view.where.size();
  BendMap bends{cv::Mat_<float>(size, 0.f), cv::Mat_<float>(size, 0.f), cv::Mat_<uchar>(size, uchar(0))};
  const Normals& normals = view.normals;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      if (!view.where(v, u) || normals.radius_px[v * size.width + u] == 0) continue;
      for (std::size_t i = 0; i < kBendDirections.size(); ++i) {
        const auto [a, b] = sidesOf(normals, size.width, size.height, u, v, i);
        if (a < 0) continue;
        const float bend = 1.f - normals.normal[a].dot(normals.normal[b]);
        const bool is_convex =
            (normals.normal[b] - normals.normal[a]).dot(view.frame.points[b] - view.frame.points[a]) > 0;
        if (bend > std::max(bends.convex(v, u), bends.concave(v, u))) bends.direction(v, u) = static_cast<uchar>(i);
        float& strongest = is_convex ? bends.convex(v, u) : bends.concave(v, u);
        strongest = std::max(strongest, bend);
      }
    }
  }
  return bends;
}

}  // namespace

TEST(PlainBends, AreTheSame) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const View view(seed);
    const BendMap plain = plainBends(view);
    EXPECT_GT(cv::countNonZero(plain.convex), 1000);
    EXPECT_GT(cv::countNonZero(plain.concave), 1000);
    for (const int threads : {1, 2}) {
      const BendMap bends = findBends(view.frame, view.normals, view.where, threads);
      EXPECT_TRUE(sameBits(bends.convex, plain.convex)) << seed;
      EXPECT_TRUE(sameBits(bends.concave, plain.concave)) << seed;
      EXPECT_TRUE(sameBits(bends.direction, plain.direction)) << seed;
    }
  }
}

TEST(PlainBends, StepsAreTheSame) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const View view(seed);
    cv::Mat_<float> plain(view.where.size(), 0.f), steps(view.where.size());
    for (int v = 0; v < plain.rows; ++v) {
      for (int u = 0; u < plain.cols; ++u) {
        if (view.where(v, u)) plain(v, u) = stepAt(view.frame, view.normals, view.where, u, v);
      }
    }
    EXPECT_GT(cv::countNonZero(plain), 1000);
    findStepsInRows(view.frame, view.normals, view.where, 0, 70, steps);
    findStepsInRows(view.frame, view.normals, view.where, 70, plain.rows, steps);
    EXPECT_TRUE(sameBits(steps, plain)) << seed;
  }
}

TEST(Creases, AreTheSameWhereverTheyAreLookedFor) {
  int creases = 0;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const View view(seed);
    const cv::Mat_<uchar> everywhere(150, 200, uchar(255));
    const BendMap bends = findBends(view.frame, view.normals, everywhere);
    const cv::Mat_<uchar> all = thinCreases(bends, view.normals, everywhere, 5);
    creases += cv::countNonZero(all);
    for (const cv::Rect& rect : {cv::Rect(0, 0, 200, 150), cv::Rect(60, 40, 70, 50), cv::Rect(0, 0, 9, 9),
                                 cv::Rect(150, 100, 50, 50), cv::Rect(80, 70, 1, 1)}) {
      cv::Mat_<uchar> where(150, 200, uchar(0));
      view.where(rect).copyTo(where(rect));
      for (const int threads : {1, 2}) {
        const cv::Mat_<uchar> found = thinCreases(bends, view.normals, where, 5, threads);
        EXPECT_TRUE(sameBits<uchar>(found, all & where)) << rect;
      }
    }
    EXPECT_EQ(cv::countNonZero(thinCreases(bends, view.normals, cv::Mat_<uchar>(150, 200, uchar(0)), 5)), 0);
  }
  EXPECT_GT(creases, 200);
}

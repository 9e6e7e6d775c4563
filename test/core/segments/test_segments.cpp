// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "fixtures/random_frame.hpp"
#include "segments/geodesic_assignment.hpp"
#include "segments/segments.hpp"

using namespace objectness;

namespace {

/// A camera-aligned "table": points lie at (u, v) centimetres, the table frame is the camera frame.
Frame flatFrame(int width, int height) {
  Frame frame;
  frame.camera = {100, 100, 0, 0, width, height};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) frame.points.emplace_back(0.01f * (u + 0.5f), 0.01f * (v + 0.5f), 0.005f);
  }
  return frame;
}

CuePoints pointsOf(const Frame& frame, const std::vector<int>& labels) {
  CuePoints points;
  points.points = frame.points;
  points.labels = labels;
  for (int i = 0; i < frame.size(); ++i) points.pixels.push_back(i);
  points.superpixels = *std::max_element(labels.begin(), labels.end());
  points.top_m = 0.005f;
  return points;
}

SelectedBox selectedBox(int x0, int x1, int y0, int y1, float objectness) {
  SelectedBox selected;
  selected.scored.box = {0, x0, x1, y0, y1, 3};
  selected.scored.objectness = objectness;
  selected.grid.nx = selected.grid.ny = 40, selected.grid.nz = 5;
  return selected;
}

const Eigen::Isometry3d kHere = Eigen::Isometry3d::Identity();

SegmentsConfig config() {
  SegmentsConfig c;
  c.min_pixels = 1;
  return c;
}

}  // namespace

TEST(Segments, PlainBoxesGiveAPixelToTheBestBoxThatHoldsIt) {
  const Frame frame = flatFrame(10, 1);
  const CuePoints points = pointsOf(frame, std::vector<int>(10, 0));
  const auto segments = cutSegments(frame, kHere, points,
                                    {selectedBox(0, 4, 0, 3, 1.2f), selectedBox(2, 8, 0, 3, 1.0f)}, 0, false, config());
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].pixels, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(segments[1].pixels, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_FLOAT_EQ(segments[0].objectness, 1.2f);
}

TEST(Segments, TheMarginCountsAsInside) {
  const Frame frame = flatFrame(10, 1);
  const CuePoints points = pointsOf(frame, std::vector<int>(10, 0));
  const std::vector<SelectedBox> boxes = {selectedBox(2, 5, 0, 3, 1)};
  EXPECT_EQ(cutSegments(frame, kHere, points, boxes, 0.004, false, config())[0].pixels.size(), 3u);
  EXPECT_EQ(cutSegments(frame, kHere, points, boxes, 0.006, false, config())[0].pixels.size(), 5u);
}

TEST(Segments, WholeSuperpixelsFollowTheBoxThatHoldsMostOfThem) {
  const Frame frame = flatFrame(12, 1);
  const CuePoints points = pointsOf(frame, {1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2});
  // The first box holds superpixel 1 and two pixels of superpixel 2, the second most of superpixel 2.
  const auto segments = cutSegments(frame, kHere, points,
                                    {selectedBox(0, 7, 0, 3, 1.2f), selectedBox(6, 11, 0, 3, 1.0f)}, 0, true, config());
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].pixels, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(segments[1].pixels, (std::vector<int>{5, 6, 7, 8, 9, 10, 11}));
}

TEST(Segments, PointsWithoutSuperpixelFollowTheirNearestSegment) {
  const Frame frame = flatFrame(12, 1);
  const CuePoints points = pointsOf(frame, {1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  SegmentsConfig c = config();
  c.max_reach_m = 0.031;
  const auto segments = cutSegments(frame, kHere, points, {selectedBox(0, 4, 0, 3, 1)}, 0, true, c);
  EXPECT_EQ(segments[0].pixels, (std::vector<int>{0, 1, 2, 3, 4, 5, 6})) << "three pixels of 1 cm, and no farther";
}

TEST(Segments, SmallSegmentsAreDroppedAndBestComeFirst) {
  const Frame frame = flatFrame(10, 1);
  const CuePoints points = pointsOf(frame, std::vector<int>(10, 0));
  SegmentsConfig c = config();
  c.min_pixels = 3;
  const auto segments =
      cutSegments(frame, kHere, points, {selectedBox(0, 2, 0, 3, 1.2f), selectedBox(3, 8, 0, 3, 1.0f)}, 0, false, c);
  ASSERT_EQ(segments.size(), 1u);
  cv::Mat_<uchar> on_table(1, 10, static_cast<uchar>(0));
  on_table(0, 0) = on_table(0, 5) = 255;
  const cv::Mat_<ushort> labels = labelImage(on_table, {}, segments);
  EXPECT_EQ(labels(0, 0), 1);
  EXPECT_EQ(labels(0, 1), 0);
  EXPECT_EQ(labels(0, 5), 2) << "a segment's pixel is no table";
}

TEST(Segments, TheOrientedBoxIsWhereItsGridSays) {
  Grid grid;
  grid.angle_rad = 0.5, grid.cosine = std::cos(0.5), grid.sine = std::sin(0.5);
  grid.origin_m = {0.1, -0.3}, grid.nx = grid.ny = 40, grid.nz = 20;
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
  T_table_camera.translate(Eigen::Vector3d(0.2, -0.1, 0.9));
  T_table_camera.rotate(Eigen::AngleAxisd(2.4, Eigen::Vector3d(1, 0.2, 0.1).normalized()));
  const Box box{0, 4, 10, 6, 9, 12};
  const OrientedBox oriented = orientedBox(box, grid, T_table_camera);
  EXPECT_LT((oriented.size_m - Eigen::Vector3d(0.06, 0.03, 0.12)).norm(), 1e-12);
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        const Eigen::Vector3d corner = oriented.T_camera_box * oriented.size_m.cwiseProduct(Eigen::Vector3d(x, y, z));
        const Eigen::Vector3d q = grid.toGrid(T_table_camera * corner);
        EXPECT_LT((q - Eigen::Vector3d(x < 0 ? 4 : 10, y < 0 ? 6 : 9, z < 0 ? 0 : 12)).norm(), 1e-9);
      }
    }
  }
}

TEST(Geodesic, StopsAtGapsOfTheSurface) {
  Frame frame = flatFrame(8, 1);
  for (int i = 4; i < 8; ++i) frame.points[i].z() += 0.1f;  // another surface behind
  cv::Mat_<uchar> open(1, 8, static_cast<uchar>(255));
  cv::Mat_<int> owner(1, 8, -1);
  owner(0, 0) = 3;
  assignGeodesic(frame, open, {0.015, 1.0}, owner);
  for (int u = 0; u < 8; ++u) EXPECT_EQ(owner(0, u), u < 4 ? 3 : -1);
}

TEST(Geodesic, GoesToTheNearerSourceAndOnlyThroughOpenPixels) {
  const Frame frame = flatFrame(9, 3);
  cv::Mat_<uchar> open(3, 9, static_cast<uchar>(255));
  for (int v = 0; v < 3; ++v) open(v, 6) = 0;  // a wall
  cv::Mat_<int> owner(3, 9, -1);
  owner(1, 0) = 0;
  owner(1, 5) = 1;
  assignGeodesic(frame, open, {0.015, 1.0}, owner);
  for (int v = 0; v < 3; ++v) {
    EXPECT_EQ(owner(v, 1), 0);
    EXPECT_EQ(owner(v, 4), 1);
    for (int u = 6; u < 9; ++u) EXPECT_EQ(owner(v, u), -1);
  }
}

TEST(Geodesic, MissingPointsAreNotCrossed) {
  Frame frame = flatFrame(5, 1);
  frame.points[2].setConstant(std::nanf(""));
  cv::Mat_<uchar> open(1, 5, static_cast<uchar>(255));
  cv::Mat_<int> owner(1, 5, -1);
  owner(0, 0) = 0;
  assignGeodesic(frame, open, {0.015, 1.0}, owner);
  EXPECT_EQ(owner(0, 1), 0);
  EXPECT_EQ(owner(0, 2), -1);
  EXPECT_EQ(owner(0, 3), -1);
}

TEST(Geodesic, IsTheShortestWayAndTheLowerOwnerOfEqualOnes) {
  std::mt19937 random(5);
  const auto below = [&](int count) { return static_cast<int>(random() % count); };
  constexpr GeodesicLimits kLimits{0.015, 0.045};
  int assigned = 0, ties = 0;
  for (int round = 0; round < 12; ++round) {
    Frame frame = flatFrame(31, 23);
    // Flat, so that many ways are equally long, or rough.
    for (auto& point : frame.points) point.z() += round % 2 ? 0.0001f * below(60) : 0;
    cv::Mat_<uchar> open(23, 31);
    cv::Mat_<int> owner(23, 31, -1);
    for (int i = 0; i < frame.size(); ++i) open(i) = below(8) ? 255 : 0;
    if (round % 3 == 0) {  // open in the middle only: sources lie beside it, too
      cv::Mat_<uchar> middle(23, 31, uchar(0));
      middle(cv::Rect(5, 3, 20, 17)) = 255;
      open &= middle;
    }
    for (int k = 0; k < 12; ++k) owner(below(frame.size())) = below(5);

    // Every pixel looks at its neighbours until nothing gets better.
    using Way = std::pair<float, int>;
    const Way none{std::numeric_limits<float>::infinity(), 0};
    std::vector<Way> best(frame.size(), none);
    for (bool better = true; better;) {
      better = false;
      for (int i = 0; i < frame.size(); ++i) {
        if (owner(i) >= 0 || !open(i)) continue;
        for (int k = 0; k < frame.size(); ++k) {
          const int du = std::abs(i % 31 - k % 31), dv = std::abs(i / 31 - k / 31);
          if (std::max(du, dv) != 1 || (owner(k) < 0 && best[k] == none)) continue;
          const float step = (frame.points[i] - frame.points[k]).norm();
          const Way way = owner(k) >= 0 ? Way{0.f + step, owner(k)} : Way{best[k].first + step, best[k].second};
          if (!(step <= kLimits.max_step_m) || way.first > kLimits.max_reach_m) continue;
          ties += way.first == best[i].first && way.second != best[i].second;
          if (way < best[i]) best[i] = way, better = true;
        }
      }
    }
    cv::Mat_<int> result = owner.clone();
    assignGeodesic(frame, open, kLimits, result);
    for (int i = 0; i < frame.size(); ++i) {
      const int expected = owner(i) >= 0 ? owner(i) : best[i] == none ? -1 : best[i].second;
      ASSERT_EQ(result(i), expected) << i << " of round " << round;
      assigned += owner(i) < 0 && result(i) >= 0;
    }
  }
  EXPECT_GT(assigned, 1500);
  EXPECT_GT(ties, 30);
}

TEST(Geodesic, IsTheSameForAnyNumberOfThreads) {
  std::mt19937 random(7);
  const Frame frame = objectness_test::randomFrame(160, 400, 3);
  cv::Mat_<uchar> open(400, 160);
  cv::Mat_<int> owner(400, 160, -1);
  for (int i = 0; i < frame.size(); ++i) open(i) = random() % 10 ? 255 : 0;
  open(cv::Rect(0, 0, 160, 25)) = 0;
  open(cv::Rect(0, 380, 160, 20)) = 0;
  for (int k = 0; k < 60; ++k) owner(random() % frame.size()) = k;
  const cv::Mat_<int> given = owner.clone();
  assignGeodesic(frame, open, {0.03, 0.08}, owner);
  int assigned = 0;
  for (int i = 0; i < frame.size(); ++i) assigned += given(i) < 0 && owner(i) >= 0;
  EXPECT_GT(assigned, 3000);
  for (const int threads : {2, 3, 16}) {
    cv::Mat_<int> other = given.clone();
    assignGeodesic(frame, open, {0.03, 0.08}, other, threads);
    EXPECT_EQ(cv::countNonZero(other != owner), 0) << threads;
  }
}

TEST(Segments, WhatIsLeftWithoutPixelsGoesAndTheOthersKeepTheirSupports) {
  std::vector<Segment> segments(4);
  segments[0].pixels = {1};
  segments[2].pixels = {2, 3};
  segments[3].pixels = {4};
  segments[2].support = {SupportKind::kSegment, 1, 0.1};  // which goes
  segments[3].support = {SupportKind::kSegment, 2, 0.2};
  segments[1].carried = {2};
  segments[2].carried = {3};
  dropEmpty(segments);
  ASSERT_EQ(segments.size(), 3u);
  EXPECT_EQ(segments[1].pixels, (std::vector<int>{2, 3}));
  EXPECT_EQ(segments[1].support.kind, SupportKind::kOther);
  EXPECT_EQ(segments[1].support.segment, -1);
  EXPECT_EQ(segments[1].support.height_m, 0.1);
  EXPECT_EQ(segments[1].carried, std::vector<int>{2});
  EXPECT_EQ(segments[2].support.kind, SupportKind::kSegment);
  EXPECT_EQ(segments[2].support.segment, 1);
  EXPECT_EQ(segments[0].support.kind, SupportKind::kTable);
}

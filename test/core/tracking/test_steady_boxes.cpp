// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "common/angles.hpp"
#include "tracking/steady_boxes.hpp"

using namespace objectness;
using Eigen::Vector3d;

namespace {

/// One pixel at that place.
Frame frameWith(const Vector3d& place) {
  Frame frame;
  frame.camera = {100, 100, 0, 0, 1, 1};
  frame.points = {place.cast<float>()};
  return frame;
}

Segment boxAt(const Vector3d& centre, double yaw_deg, const Vector3d& size, bool round = false) {
  Segment segment;
  segment.box.T_camera_box.translation() = centre;
  segment.box.T_camera_box.rotate(Eigen::AngleAxisd(yaw_deg * kDegree, Vector3d::UnitZ()));
  segment.box.size_m = size;
  segment.round = round;
  segment.pixels = {0};
  return segment;
}

std::vector<Identity> identity(std::uint64_t id) {
  std::vector<Identity> identities(1);
  identities[0].id = id;
  return identities;
}

const Vector3d kPlace(0, 0, 1), kSize(0.2, 0.1, 0.15);
const Eigen::Isometry3d kStill = Eigen::Isometry3d::Identity();

double yawOf(const OrientedBox& box) {
  const Eigen::Matrix3d axes = box.T_camera_box.linear();
  return std::atan2(axes(1, 0), axes(0, 0)) / kDegree;
}

}  // namespace

TEST(SteadyBoxes, AreTheMediansOfTheLastFrames) {
  SteadyBoxes boxes;
  const double yaws_deg[] = {10, 14, 12, 60, 11}, lengths_m[] = {0.20, 0.22, 0.21, 0.40, 0.19};
  std::vector<Segment> segments;
  for (int k = 0; k < 5; ++k) {
    segments = {boxAt(kPlace + Vector3d(0.001 * k, 0, 0), yaws_deg[k], {lengths_m[k], 0.1, 0.15})};
    boxes.settle(frameWith(kPlace), identity(3), kStill, 5, segments);
  }
  // 60 degrees are nearer to the others as -30: x and y exchanged.
  EXPECT_NEAR(yawOf(segments[0].box), 11, 1e-6);
  EXPECT_NEAR(segments[0].box.size_m.x(), 0.20, 1e-9);
  EXPECT_NEAR(segments[0].box.T_camera_box.translation().x(), 0.002, 1e-9);
}

TEST(SteadyBoxes, KeepTheNamesOfAxesWhereSidesAreNearlyEqual) {
  SteadyBoxes boxes;
  for (int k = 0; k < 6; ++k) {
    // The longer side is one or the other.
    std::vector<Segment> segments = {k % 2 ? boxAt(kPlace, 95, {0.101, 0.1, 0.1})
                                           : boxAt(kPlace, 5, {0.101, 0.1, 0.1})};
    boxes.settle(frameWith(kPlace), identity(1), kStill, 9, segments);
    EXPECT_NEAR(yawOf(segments[0].box), 5, 1e-6) << k;
  }
}

TEST(SteadyBoxes, BeginAnewWhereSomethingMoved) {
  SteadyBoxes boxes;
  for (int k = 0; k < 5; ++k) {
    std::vector<Segment> segments = {boxAt(kPlace, 0, kSize)};
    boxes.settle(frameWith(kPlace), identity(1), kStill, 9, segments);
  }
  const Vector3d there = kPlace + Vector3d(0.02, 0, 0);
  std::vector<Segment> segments = {boxAt(there, 30, kSize)};
  boxes.settle(frameWith(there), identity(1), kStill, 9, segments);
  EXPECT_NEAR(yawOf(segments[0].box), 30, 1e-6);
  EXPECT_NEAR(segments[0].box.T_camera_box.translation().x(), 0.02, 1e-9);
}

TEST(SteadyBoxes, OfACameraThatMovesStayInTheRoom) {
  SteadyBoxes boxes;
  for (int k = 0; k < 4; ++k) {
    Eigen::Isometry3d T_fixed_camera = Eigen::Isometry3d::Identity();
    T_fixed_camera.translation() = Vector3d(0.1 * k, 0, 0);
    const Vector3d seen = T_fixed_camera.inverse() * kPlace;
    std::vector<Segment> segments = {boxAt(seen, 10, kSize)};
    boxes.settle(frameWith(seen), identity(1), T_fixed_camera, 9, segments);
    EXPECT_TRUE(segments[0].box.T_camera_box.translation().isApprox(seen, 1e-7)) << k;
  }
}

TEST(SteadyBoxes, WhatIsTakenForRoundOnceIsNot) {
  SteadyBoxes boxes;
  std::vector<Segment> segments;
  for (const bool round : {false, false, true}) {
    segments = {boxAt(kPlace, round ? 40 : 10, round ? Vector3d(0.3, 0.3, 0.15) : kSize, round)};
    boxes.settle(frameWith(kPlace), identity(1), kStill, 9, segments);
  }
  EXPECT_FALSE(segments[0].round);
  EXPECT_NEAR(segments[0].box.size_m.x(), 0.2, 1e-9);
}

TEST(SteadyBoxes, OfOneFrameStayAsTheyAre) {
  SteadyBoxes boxes;
  for (const double yaw_deg : {10, 20, 60}) {
    std::vector<Segment> segments = {boxAt(kPlace, yaw_deg, kSize)};
    boxes.settle(frameWith(kPlace), identity(1), kStill, 1, segments);
    EXPECT_NEAR(yawOf(segments[0].box), yaw_deg, 1e-9);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "grouping/group_box.hpp"

using namespace objectness;

namespace {

constexpr double kMinSize_m = 0.005;

/// Points of the surface of a box, evenly at random.
std::vector<Eigen::Vector3f> surfaceOf(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size) {
  std::mt19937 random(6);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 6000; ++i) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = random() / 4294967296.0 - 0.5;
    const int axis = static_cast<int>(random() % 3);
    p[axis] = random() % 2 ? 0.5 : -0.5;
    points.push_back((pose * p.cwiseProduct(size)).cast<float>());
  }
  return points;
}

Eigen::Isometry3d pose(const Eigen::Vector3d& at, double yaw_deg, double tilt_deg) {
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(yaw_deg * M_PI / 180, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(tilt_deg * M_PI / 180, Eigen::Vector3d::UnitX());
}

std::vector<Eigen::Vector3f> axesOf(const Eigen::Isometry3d& T) {
  const Eigen::Matrix3f R = T.linear().cast<float>();
  return {R.col(0), R.col(1), R.col(2)};
}

void expectRightHanded(const OrientedBox& box) {
  const Eigen::Matrix3d& R = box.T_camera_box.linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-5);
  EXPECT_NEAR(R.determinant(), 1, 1e-5);
}

/// The same solid: each axis of the one is an axis of the other, either way, and as long.
void expectSameBox(const OrientedBox& box, const Eigen::Isometry3d& T, const Eigen::Vector3d& size,
                   double tolerance_m) {
  expectRightHanded(box);
  EXPECT_LT((box.T_camera_box.translation() - T.translation()).norm(), tolerance_m);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d cosines = (box.T_camera_box.linear().transpose() * T.linear().col(axis)).cwiseAbs();
    int own = 0;
    EXPECT_GT(cosines.maxCoeff(&own), std::cos(2 * M_PI / 180)) << "axis " << axis;
    EXPECT_NEAR(box.size_m[own], size[axis], tolerance_m) << "axis " << axis;
  }
  const Eigen::Vector3d up = box.T_camera_box.linear().row(2);
  EXPECT_GE(up[2], up.cwiseAbs().maxCoeff() - 1e-6) << "z is the axis nearest to the table's normal";
}

}  // namespace

TEST(GroupBox, UprightBoxesAtAnyHeightAndYaw) {
  const Eigen::Vector3d size(0.2, 0.11, 0.07);
  for (const double height : {0.035, 0.3, 1.1}) {
    for (const double yaw : {0.0, 10.0, 45.0, 80.0, 135.0}) {
      SCOPED_TRACE(testing::Message() << "height " << height << " yaw " << yaw);
      const Eigen::Isometry3d T = pose({0.4, -0.2, height}, yaw, 0);
      expectSameBox(tightBox(surfaceOf(T, size), {}, kMinSize_m), T, size, 0.005);
      expectSameBox(tightBox(surfaceOf(T, size), axesOf(T), kMinSize_m), T, size, 0.005);
    }
  }
}

TEST(GroupBox, LeaningBoxesAlongAnyOfTheirDirections) {
  const Eigen::Vector3d size(0.16, 0.03, 0.22);
  for (const double tilt : {15.0, 30.0, 44.0, 60.0, 75.0}) {
    const Eigen::Isometry3d T = pose({-0.1, 0.2, 0.12}, 30, tilt);
    for (const Eigen::Vector3f& direction : axesOf(T)) {
      if (std::abs(direction.z()) < 0.1) continue;  // level: does not say how the box leans
      SCOPED_TRACE(testing::Message() << "tilt " << tilt << " along " << direction.transpose());
      expectSameBox(tightBox(surfaceOf(T, size), {direction}, kMinSize_m), T, size, 0.006);
      expectSameBox(tightBox(surfaceOf(T, size), {-direction}, kMinSize_m), T, size, 0.006);
    }
  }
}

TEST(GroupBox, LeansOnlyWhereThatIsClearlySmaller) {
  const Eigen::Isometry3d upright = pose({0, 0, 0.1}, 20, 0), leaning = pose({0, 0, 0.1}, 20, 35);
  const auto up = [](const OrientedBox& box) { return box.T_camera_box.linear()(2, 2); };
  const Eigen::Vector3d size(0.2, 0.1, 0.15);
  EXPECT_NEAR(up(tightBox(surfaceOf(upright, size), axesOf(leaning), kMinSize_m)), 1, 1e-6) << "wrong directions";
  EXPECT_NEAR(up(tightBox(surfaceOf(leaning, size), {}, kMinSize_m)), 1, 1e-6) << "no direction";
  EXPECT_LT(up(tightBox(surfaceOf(leaning, size), axesOf(leaning), kMinSize_m)), 0.9);
  // 3 degrees are within what a normal is off.
  const Eigen::Isometry3d hardly = pose({0, 0, 0.1}, 20, 3);
  EXPECT_NEAR(up(tightBox(surfaceOf(hardly, {0.2, 0.01, 0.2}), axesOf(hardly), kMinSize_m)), 1, 1e-6);
}

TEST(GroupBox, AHundredthOfThePointsMayBeFarOff) {
  const Eigen::Vector3d size(0.2, 0.11, 0.07);
  const Eigen::Isometry3d T = pose({0, 0, 0.035}, 0, 0);
  std::vector<Eigen::Vector3f> points = surfaceOf(T, size);
  for (int i = 0; i < 20; ++i) points.emplace_back(0.f, 0.f, 0.3f + 0.01f * i);
  EXPECT_NEAR(tightBox(points, {}, kMinSize_m).size_m.z(), 0.07, 0.005);
}

TEST(GroupBox, FewAndFlatPointsHaveTheLeastSize) {
  const Eigen::Vector3f at(0.1f, 0.2f, 0.3f);
  std::vector<Eigen::Vector3f> line, sheet;
  for (int i = 0; i <= 200; ++i) {
    line.push_back(at + Eigen::Vector3f(0.001f * (i - 100), 0.001f * (i - 100), 0));
    for (int k = 0; k <= 50; ++k) sheet.push_back(at + Eigen::Vector3f(0.001f * (i - 100), 0.001f * (k - 25), 0));
  }
  const struct {
    const char* name;
    std::vector<Eigen::Vector3f> points;
    Eigen::Vector3d sorted_size;
  } cases[] = {{"a point", {at}, {kMinSize_m, kMinSize_m, kMinSize_m}},
               {"a point twice", {at, at}, {kMinSize_m, kMinSize_m, kMinSize_m}},
               {"a level line", line, {kMinSize_m, kMinSize_m, 0.2 * std::sqrt(2.0)}},
               {"a level sheet", sheet, {kMinSize_m, 0.05, 0.2}}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const OrientedBox box = tightBox(c.points, {Eigen::Vector3f(0, 0.6f, 0.8f)}, kMinSize_m);
    ASSERT_TRUE(box.T_camera_box.matrix().allFinite());
    expectRightHanded(box);
    Eigen::Vector3d size = box.size_m;
    std::sort(size.data(), size.data() + 3);
    EXPECT_LT((size - c.sorted_size).norm(), 0.01) << size.transpose();
    EXPECT_LT((box.T_camera_box.translation() - at.cast<double>()).norm(), 1e-3);
  }
}

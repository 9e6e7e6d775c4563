// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "evaluation/box_overlap.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using Eigen::Vector3d;

namespace {

OrientedBox boxAt(const Vector3d& centre, const Vector3d& size, double yaw = 0) {
  OrientedBox box;
  box.T_camera_box.translation() = centre;
  box.T_camera_box.rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  box.size_m = size;
  return box;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
  Vector3d vector(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high);
    return {x, y, uniform(low, high)};
  }
  OrientedBox box() {
    OrientedBox box = boxAt(vector(-0.1, 0.1), vector(0.05, 0.3));
    Eigen::Quaterniond q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    box.T_camera_box.linear() = q.normalized().toRotationMatrix();
    return box;
  }

 private:
  std::mt19937 engine_;
};

bool holds(const OrientedBox& box, const Vector3d& p) {
  return ((box.T_camera_box.inverse() * p).cwiseAbs().array() <= 0.5 * box.size_m.array()).all();
}

}  // namespace

TEST(BoxOverlap, UprightBoxes) {
  const OrientedBox unit = boxAt({0, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(boxOverlap(unit, unit), 1, 1e-7);
  EXPECT_NEAR(boxOverlap(unit, boxAt({0.5, 0, 0}, {1, 1, 1})), 1.0 / 3, 1e-7);
  EXPECT_NEAR(boxOverlap(unit, boxAt({0.5, 0.5, 0.5}, {1, 1, 1})), 0.125 / 1.875, 1e-7);
  EXPECT_NEAR(boxOverlap(unit, boxAt({0.1, 0, -0.2}, {0.5, 0.4, 0.3})), 0.06, 1e-7) << "one within the other";
  EXPECT_NEAR(boxOverlap(unit, boxAt({0, 0, 0.25}, {1, 1, 0.5})), 0.5, 1e-7) << "five faces coincide in part";
  EXPECT_NEAR(boxOverlap(unit, boxAt({1, 0, 0}, {1, 1, 1})), 0, 1e-7) << "they touch";
  EXPECT_EQ(boxOverlap(unit, boxAt({3, 0, 0}, {1, 1, 1})), 0);
  EXPECT_EQ(boxOverlap(unit, boxAt({0, 0, 0}, {1, 1, 0})), 0) << "flat";
}

TEST(BoxOverlap, TurnedBoxes) {
  const double octagon = 2 * (std::sqrt(2.0) - 1);
  const OrientedBox unit = boxAt({0, 0, 0}, {1, 1, 1}), turned = boxAt({0, 0, 0}, {1, 1, 1}, std::atan(1.0));
  EXPECT_NEAR(sharedVolume(unit, turned), octagon, 1e-7);
  EXPECT_NEAR(boxOverlap(unit, turned), octagon / (2 - octagon), 1e-7);
  EXPECT_NEAR(boxOverlap(unit, boxAt({0, 0, 0}, {1, 1, 1}, 2 * std::atan(1.0))), 1, 1e-7) << "a quarter turn";
}

TEST(BoxOverlap, ACornerThatIsCutOff) {
  // A large box whose face lies square to the unit cube's diagonal, 0.2 from the corner: it holds a tetrahedron.
  OrientedBox large = boxAt({0, 0, 0}, {10, 10, 10});
  const Vector3d diagonal = Vector3d::Ones().normalized();
  large.T_camera_box.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), diagonal).toRotationMatrix();
  large.T_camera_box.translation() = Vector3d::Constant(0.5) + (5 - 0.2) * diagonal;
  const double leg = 0.2 * std::sqrt(3.0);
  EXPECT_NEAR(sharedVolume(boxAt({0, 0, 0}, {1, 1, 1}), large), leg * leg * leg / 6, 1e-7);
}

TEST(BoxOverlap, AnyOrientationAgreesWithRandomPoints) {
  Random random(11);
  constexpr int kPoints = 40000;
  for (int pair = 0; pair < 50; ++pair) {
    const OrientedBox a = random.box(), b = random.box();
    int shared = 0;
    for (int i = 0; i < kPoints; ++i) {
      const Vector3d inside = random.vector(-0.5, 0.5).cwiseProduct(a.size_m);
      shared += holds(b, a.T_camera_box * inside);
    }
    const double share = static_cast<double>(shared) / kPoints;
    const double sigma = std::sqrt(std::max(share * (1 - share), 1.0 / kPoints) / kPoints);
    EXPECT_NEAR(sharedVolume(a, b) / a.size_m.prod(), share, 4.5 * sigma) << "pair " << pair;
    EXPECT_NEAR(sharedVolume(a, b), sharedVolume(b, a), 1e-9);
  }
}

TEST(BoxOverlap, DoesNotDependOnTheFrame) {
  Random random(5);
  for (int pair = 0; pair < 20; ++pair) {
    OrientedBox a = random.box(), b = random.box();
    const double before = boxOverlap(a, b);
    const Eigen::Isometry3d motion = Eigen::Translation3d(random.vector(-2, 2)) * random.box().T_camera_box;
    a.T_camera_box = motion * a.T_camera_box;
    b.T_camera_box = motion * b.T_camera_box;
    EXPECT_NEAR(boxOverlap(a, b), before, 1e-6);
  }
}

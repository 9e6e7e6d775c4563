// SPDX-License-Identifier: BSD-3-Clause
// What the whole of a thing is inferred with: each fit on points whose shape is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/angles.hpp"
#include "segments/box_axes.hpp"
#include "segments/leaning_slab.hpp"
#include "segments/plan_rectangle.hpp"
#include "segments/round_fit.hpp"

using namespace objectness;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

double uniform(std::mt19937& random, double low, double high) { return low + (high - low) * random() / 4294967296.0; }

void addPoint(const Vector3d& place, const Vector3d& normal, SeenThing& thing) {
  SeenPoint q;
  q.place = place.cast<float>();
  q.normal = normal.normalized().cast<float>();
  q.upright = q.normal.head<2>().norm();
  q.has_normal = true;
  if (q.normal.dot(thing.eye - q.place) > 0) thing.points.push_back(q);
}

SeenThing emptyThing(double height_m) {
  SeenThing thing;
  thing.eye = {0, 0, 0.6f};
  thing.top_m = height_m;
  thing.sigma_m = 0.001;
  return thing;
}

/// The half of a cone's wall that the camera sees, with noise across it.
SeenThing coneWall(const Vector2d& axis, double foot_radius, double top_radius, double height, double noise_m,
                   std::mt19937& random) {
  SeenThing thing = emptyThing(height);
  const double slope = (foot_radius - top_radius) / height;
  for (int i = 0; i < 700; ++i) {
    const double z = uniform(random, 0, height), angle = uniform(random, -kPi, kPi);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const double radius = foot_radius - slope * z + noise_m * uniform(random, -1.7, 1.7);
    addPoint(Vector3d(axis.x(), axis.y(), z) + radius * out, out + Vector3d(0, 0, slope), thing);
  }
  return thing;
}

/// What the camera sees of an upright box, as the points of its faces.
SeenThing boxFaces(const Eigen::Isometry3d& pose, const Vector3d& size, std::mt19937& random) {
  SeenThing thing = emptyThing(size.z());
  for (int i = 0; i < 3000; ++i) {
    const int axis = static_cast<int>(random() % 3);
    const double side = random() % 2 ? 0.5 : -0.5;
    Vector3d own(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
    own[axis] = side;
    addPoint(pose * own.cwiseProduct(size), pose.linear() * (2 * side * Vector3d::Unit(axis)), thing);
  }
  return thing;
}

Eigen::Isometry3d standing(const Vector2d& at, double height, double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << at, 0.5 * height;
  pose.rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  return pose;
}

}  // namespace

TEST(RoundFit, FindsAxisAndRadiusOfWhatIsSeenOfACan) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const Vector2d axis(uniform(random, -0.3, 0.3), uniform(random, 0.5, 0.9));
    const double radius = uniform(random, 0.025, 0.1);
    const auto fit = fitRound(coneWall(axis, radius, radius, uniform(random, 0.06, 0.25), 0.001, random));
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->axis - axis).norm(), 0.002) << "radius " << radius;
    EXPECT_NEAR(fit->radius_m, radius, 0.002);
    EXPECT_LT(fit->turn_deg, 5);
    EXPECT_LT(fit->spread_m, 0.003);
    EXPECT_EQ(fit->beyond, 0);
  }
}

TEST(RoundFit, ContinuesAConeToItsFoot) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Vector2d axis(uniform(random, -0.3, 0.3), uniform(random, 0.5, 0.9));
    const double radius = uniform(random, 0.04, 0.08), height = uniform(random, 0.1, 0.15);
    SeenThing cone = coneWall(axis, radius, 0, height, 0.0005, random);
    const auto hidden = [&](const SeenPoint& q) { return q.place.z() < 0.2 * height; };
    cone.points.erase(std::remove_if(cone.points.begin(), cone.points.end(), hidden), cone.points.end());
    const auto fit = fitRound(cone);
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->axis - axis).norm(), 0.003);
    EXPECT_NEAR(fit->radius_m, radius, 0.07 * radius);
  }
}

TEST(RoundFit, IsNoWorseThanAnyPlaceOfAGrid) {
  // Brute force: the place on a grid of half a millimetre with the least spread of the radius.
  std::mt19937 random(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Vector2d axis(uniform(random, -0.3, 0.3), uniform(random, 0.5, 0.9));
    const SeenThing can = coneWall(axis, 0.04, 0.04, 0.12, 0.0015, random);
    const auto spread = [&](const Vector2d& at) {
      double sum = 0, squares = 0;
      for (const SeenPoint& q : can.points) {
        const double r = (q.place.head<2>().cast<double>() - at).norm();
        sum += r, squares += r * r;
      }
      const double n = static_cast<double>(can.points.size());
      return squares / n - sum * sum / n / n;
    };
    Vector2d best = axis;
    for (int i = -20; i <= 20; ++i) {
      for (int j = -20; j <= 20; ++j) {
        const Vector2d at = axis + 0.0005 * Vector2d(i, j);
        if (spread(at) < spread(best)) best = at;
      }
    }
    const auto fit = fitRound(can);
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->axis - best).norm(), 0.002);
  }
}

TEST(RoundFit, TellsOfAHandleWithoutMovingTheAxis) {
  std::mt19937 random(4);
  const Vector2d axis(0.1, 0.7);
  SeenThing mug = coneWall(axis, 0.04, 0.04, 0.1, 0.0005, random);
  for (int i = 0; i < 40; ++i) {
    addPoint({axis.x() + uniform(random, 0.05, 0.075), axis.y(), uniform(random, 0.02, 0.08)}, {0, -1, 0.1}, mug);
  }
  const auto fit = fitRound(mug);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->axis - axis).norm(), 0.002);
  EXPECT_NEAR(fit->radius_m, 0.04, 0.002);
  EXPECT_GT(fit->beyond, 0.05);
  EXPECT_GT(fit->one_sided, 0.95);
  EXPECT_NEAR(fit->reach_m, 0.075, 0.003);
  EXPECT_GT(fit->to_beyond.normalized().x(), 0.99);
}

TEST(RoundFit, NeedsAWall) {
  EXPECT_FALSE(fitRound(emptyThing(0.1)));
  std::mt19937 random(5);
  SeenThing level = emptyThing(0.1);
  for (int i = 0; i < 200; ++i) addPoint({uniform(random, 0, 0.1), 0.6, 0.1}, Vector3d::UnitZ(), level);
  EXPECT_FALSE(fitRound(level));
}

TEST(PlanRectangle, IsThatOfTheFaces) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 30; ++trial) {
    const double yaw = uniform(random, -kPi, kPi);
    const Vector3d size(uniform(random, 0.06, 0.2), uniform(random, 0.06, 0.2), uniform(random, 0.05, 0.2));
    const Vector2d at(uniform(random, -0.3, 0.3), uniform(random, 0.6, 0.9));
    const SeenThing thing = boxFaces(standing(at, size.z(), yaw), size, random);
    const FaceDirection faces = faceDirection(thing);
    EXPECT_GT(faces.agreement, 0.999);
    EXPECT_LT(faces.turn_deg, 0.1);
    const PlanRectangle rectangle = seenRectangle(thing, faces);
    EXPECT_LT(std::abs(std::remainder(rectangle.yaw_rad - yaw, kPi / 2)), 1e-3);
    const bool quarter = std::abs(std::remainder(rectangle.yaw_rad - yaw, kPi)) > kPi / 4;
    const Vector2d sides = rectangle.high - rectangle.low;
    EXPECT_NEAR(sides[quarter ? 1 : 0], size.x(), 0.006);
    EXPECT_NEAR(sides[quarter ? 0 : 1], size.y(), 0.006);
    EXPECT_LT((rectangle.toPlan(0.5 * (rectangle.low + rectangle.high)) - at).norm(), 0.005);
    EXPECT_LT((rectangle.toOwn(rectangle.toPlan({0.1, 0.2})) - Vector2d(0.1, 0.2)).norm(), 1e-12);
  }
}

TEST(LeaningSlab, IsFoundAtItsTilt) {
  std::mt19937 random(7);
  for (const double tilt_deg : {15.0, 25.0, 40.0, 55.0, -20.0}) {
    SCOPED_TRACE(tilt_deg);
    const Vector3d size(0.18, 0.03, 0.22);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() << 0.1, 0.7, 0.12;
    pose.rotate(Eigen::AngleAxisd(0.4, Vector3d::UnitZ()) * Eigen::AngleAxisd(-tilt_deg * kDegree, Vector3d::UnitX()));
    SeenThing thing = emptyThing(0.24);
    for (int i = 0; i < 900; ++i) {  // the face towards the camera, and one in six on the edges
      Vector3d own(uniform(random, -0.5, 0.5), -0.5, uniform(random, -0.5, 0.5));
      Vector3d normal = -Vector3d::UnitY();
      if (i % 6 == 0) own = {uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5), 0.5}, normal = Vector3d::UnitZ();
      addPoint(pose * own.cwiseProduct(size), pose.linear() * normal, thing);
    }
    const auto box = fitLeaningSlab(thing);
    ASSERT_TRUE(box);
    const OrientedBox named = nameAxes(*box);
    if (std::abs(tilt_deg) < 40) {
      EXPECT_GT(named.T_camera_box.linear().col(2).dot(pose.linear().col(2)), 0.999);
    }
    Vector3d sizes = named.size_m, expected = size;
    std::sort(sizes.data(), sizes.data() + 3);
    std::sort(expected.data(), expected.data() + 3);
    // Behind the face only what is seen of the edges tells the thickness.
    EXPECT_LT((sizes - expected).tail<2>().cwiseAbs().maxCoeff(), 0.005);
    EXPECT_LE(sizes[0], expected[0] + 0.001);
  }
}

TEST(LeaningSlab, IsNoneThatStands) {
  std::mt19937 random(8);
  EXPECT_FALSE(fitLeaningSlab(boxFaces(standing({0.1, 0.7}, 0.2, 0.3), {0.2, 0.03, 0.2}, random)));
  EXPECT_FALSE(fitLeaningSlab(coneWall({0, 0.7}, 0.05, 0.05, 0.2, 0.0005, random)));
}

TEST(BoxAxes, AreTheSameForEveryNameOfABox) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    OrientedBox box;
    box.size_m << uniform(random, 0.02, 0.2), uniform(random, 0.02, 0.2), uniform(random, 0.02, 0.2);
    box.T_camera_box = standing({0.1, 0.2}, 0.1, uniform(random, -kPi, kPi));
    if (trial % 2) box.T_camera_box.rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitX()));
    const OrientedBox first = nameAxes(box);
    const Eigen::Matrix3d axes = first.T_camera_box.linear();
    EXPECT_NEAR(axes.determinant(), 1, 1e-9);
    EXPECT_GT(axes(2, 2), 0.7);
    EXPECT_GE(1.03 * first.size_m.x(), first.size_m.y());
    EXPECT_GE(axes(0, 0), 0);
    // All 24 right-handed names of the same axes.
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 3; ++y) {
        if (x == y) continue;
        for (int signs = 0; signs < 4; ++signs) {
          OrientedBox other = box;
          const Vector3d u = (signs & 1 ? -1 : 1) * box.T_camera_box.linear().col(x);
          const Vector3d v = (signs & 2 ? -1 : 1) * box.T_camera_box.linear().col(y);
          other.T_camera_box.linear() << u, v, u.cross(v);
          other.size_m = {box.size_m[x], box.size_m[y], box.size_m[3 - x - y]};
          const OrientedBox again = nameAxes(other);
          EXPECT_LT((again.T_camera_box.linear() - axes).norm(), 1e-9);
          EXPECT_LT((again.size_m - first.size_m).norm(), 1e-12);
        }
      }
    }
  }
}

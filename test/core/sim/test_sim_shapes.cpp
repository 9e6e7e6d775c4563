// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "sim/bodies.hpp"
#include "sim/intersect.hpp"
#include "sim/profiles.hpp"
#include "sim/random.hpp"

using namespace objectness::sim;
using Eigen::Vector3d;

namespace {

struct NamedShape {
  const char* name;
  Shape shape;
};

void PrintTo(const NamedShape& named, std::ostream* out) { *out << named.name; }

Vector3d pointIn(const Eigen::AlignedBox3d& box, Random& random) {
  Vector3d share;
  for (int k = 0; k < 3; ++k) share[k] = random.uniform(0, 1);
  return box.min() + share.cwiseProduct(box.sizes());
}

/// From a sphere about the shape into its bounding box; every tenth along an axis, every tenth through the z axis.
Ray drawRay(const Shape& shape, int i, Random& random) {
  const Eigen::AlignedBox3d box = bounds(shape);
  Vector3d target = pointIn(box, random), away;
  for (int k = 0; k < 3; ++k) away[k] = random.gaussian();
  if (i % 10 == 0) away = (i % 20 ? 1 : -1) * Vector3d::Unit(i / 20 % 3);
  if (i % 10 == 5) target.head<2>().setZero();
  return {target + away.normalized() * 2 * box.diagonal().norm(), -away.normalized() * random.uniform(0.3, 3)};
}

class EveryShape : public testing::TestWithParam<NamedShape> {};

constexpr int kRays = 1500;
constexpr double kStep_m = 2e-4, kEpsilon_m = 1e-7;

}  // namespace

TEST_P(EveryShape, IsHitWhereMarchingFirstGetsInside) {
  const Shape& shape = GetParam().shape;
  Random random(1);
  int hits = 0;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = drawRay(shape, i, random);
    const std::optional<Hit> hit = intersect(shape, ray);
    const double speed = ray.direction.norm(), end = 4 * bounds(shape).diagonal().norm() / speed;
    for (double t = 0; t < (hit ? hit->t - kEpsilon_m : end); t += kStep_m / speed) {
      ASSERT_FALSE(inside(shape, ray.at(t))) << "ray " << i << " is inside before its hit, " << t * speed << " m on";
    }
    if (!hit) continue;
    ++hits;
    const Vector3d point = ray.at(hit->t);
    EXPECT_TRUE(inside(shape, point - kEpsilon_m * hit->normal)) << "ray " << i;
    EXPECT_FALSE(inside(shape, point + kEpsilon_m * hit->normal)) << "ray " << i;
  }
  EXPECT_GT(hits, kRays / 5);
}

TEST_P(EveryShape, HasUnitNormalsAcrossTheSurface) {
  const Shape& shape = GetParam().shape;
  Random random(2);
  int compared = 0;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = drawRay(shape, i, random);
    const std::optional<Hit> hit = intersect(shape, ray);
    if (!hit) continue;
    ASSERT_NEAR(hit->normal.norm(), 1, 1e-9);
    ASSERT_LT(hit->normal.dot(ray.direction), 0);
    Vector3d aside;
    for (int k = 0; k < 3; ++k) aside[k] = 1e-6 * random.gaussian();
    const Ray beside{ray.origin + aside, ray.direction};
    const std::optional<Hit> next = intersect(shape, beside);
    if (!next || next->normal.dot(hit->normal) < 1 - 1e-6) continue;  // across an edge
    const Vector3d along = beside.at(next->t) - ray.at(hit->t);
    if (along.norm() > 1e-4) continue;  // seen at a flat angle
    EXPECT_NEAR(hit->normal.dot(along) / along.norm(), 0, 1e-2) << "ray " << i;
    ++compared;
  }
  EXPECT_GT(compared, kRays / 10);
}

TEST_P(EveryShape, FillsItsBounds) {
  const Shape& shape = GetParam().shape;
  const Eigen::AlignedBox3d box = bounds(shape);
  const Eigen::AlignedBox3d wider(box.min() - 0.3 * box.sizes(), box.max() + 0.3 * box.sizes());
  Random random(3);
  Eigen::AlignedBox3d filled;
  for (int i = 0; i < 200000; ++i) {
    const Vector3d point = pointIn(wider, random);
    if (inside(shape, point)) filled.extend(point);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(filled.min()[axis], box.min()[axis] - 1e-12);
    EXPECT_LE(filled.max()[axis], box.max()[axis] + 1e-12);
    EXPECT_GT(filled.sizes()[axis], 0.9 * box.sizes()[axis]);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, EveryShape,
    testing::Values(NamedShape{"box", Box{{0.2, 0.1, 0.3}}}, NamedShape{"cylinder", cylinder(0.04, 0.12)},
                    NamedShape{"cone", cone(0.06, 0, 0.15)}, NamedShape{"frustum", cone(0.06, 0.03, 0.1)},
                    NamedShape{"funnel", cone(0.03, 0.06, 0.1)}, NamedShape{"sphere", sphere(0.05)},
                    NamedShape{"bowl", bowl(0.09, 0.05, 0.005, 0.08)}, NamedShape{"cup", cup(0.04, 0.1, 0.004)},
                    NamedShape{"plate", dish(0.1, 0.03, 0.008, 0.06)}, NamedShape{"pan", dish(0.08, 0.05, 0.003, 0.07)},
                    NamedShape{"lid", lid(0.08, 0.006, 0.03, 0.012, 0.02)},
                    NamedShape{"bottle", bottle(0.04, 0.25, 0.014, 0.14, 0.19)},
                    NamedShape{"handle", handle(0.04, 0.004, 0.05, 0.055, 0.006)}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Shapes, KnownHits) {
  const auto top = intersect(Box{{0.2, 0.4, 0.3}}, {{0.05, 0.1, 2}, {0, 0, -1}});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->t, 1.7, 1e-12);
  EXPECT_TRUE(top->normal.isApprox(Vector3d::UnitZ()));
  const auto side = intersect(cylinder(0.1, 0.3), {{0.06, -1, 0.2}, {0, 1, 0}});
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->t, 1 - 0.08, 1e-12);
  EXPECT_TRUE(side->normal.isApprox(Vector3d(0.6, -0.8, 0), 1e-9));
  EXPECT_FALSE(intersect(cylinder(0.1, 0.3), {{0, -1, 0.31}, {0, 1, 0}}));
  const auto slope = intersect(cone(0.1, 0, 0.1), {{1, 0, 0.05}, {-1, 0, 0}});
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->t, 0.95, 1e-12);
  EXPECT_TRUE(slope->normal.isApprox(Vector3d(1, 0, 1).normalized(), 1e-9));
  const auto along_slope = intersect(cone(0.1, 0, 0.1), {{1.01, 0, -0.9}, {-1, 0, 1}});
  EXPECT_FALSE(along_slope) << "parallel to the slope, a centimetre beside it";
}

TEST(Shapes, HaveNoPinholesAtTheirPoles) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const double radius = random.uniform(0.01, 0.2), x = random.uniform(-0.1, 0.1);
    const Ray up{{0, 0, -random.uniform(0.1, 1)}, {0, 0, random.uniform(0.1, 2)}};
    const auto pole = intersect(sphere(radius), up);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(up.at(pole->t).z(), 0, 1e-9);
    const auto seam = intersect(bottle(0.1, 0.3, 0.1, 0.1, 0.2), {{x, -1, i % 2 ? 0.1 : 0.2}, {0, 1, 0}});
    ASSERT_TRUE(seam);
    EXPECT_NEAR(seam->t, 1 - std::sqrt(0.01 - x * x), 1e-6);
  }
}

TEST(Shapes, TheBowlIsHollow) {
  const Revolution shape = bowl(0.1, 0.08, 0.01, 0.09);
  const auto floor = intersect(shape, {{0, 0, 1}, {0, 0, -1}});
  ASSERT_TRUE(floor);
  EXPECT_NEAR(1 - floor->t, 0.01, 1e-12) << "the inner floor, one wall over the foot";
  const double inner = std::sqrt(0.09 * 0.09 - 0.01 * 0.01), outer = std::sqrt(0.1 * 0.1 - 0.01 * 0.01);
  EXPECT_NEAR(intersect(shape, {{(inner + outer) / 2, 0, 1}, {0, 0, -1}})->t, 1 - 0.08, 1e-12) << "the rim";
  EXPECT_FALSE(intersect(shape, {{outer + 1e-3, 0, 1}, {0, 0, -1}}));
  EXPECT_NEAR(intersect(shape, {{-1, 0, 0.05}, {1, 0, 0}})->t, 1 - std::sqrt(0.01 - 0.04 * 0.04), 1e-12);
}

TEST(RayCaster, FindsTheNearestBodyAndWhatLiesBetween) {
  std::vector<Body> bodies(2);
  bodies[0].shape = sphere(0.1);
  bodies[0].T_world_body = Eigen::Translation3d(0, 0, 1) * Eigen::AngleAxisd(1, Vector3d::UnitX());
  bodies[1].shape = Box{{1, 1, 0.1}};
  const RayCaster caster(bodies);
  const Vector3d centre = bodies[0].T_world_body * Vector3d(0, 0, 0.1);
  const SceneHit hit = caster.first({centre + Vector3d(0, 0, 2), {0, 0, -0.5}});
  ASSERT_EQ(hit.body, &bodies[0]);
  EXPECT_NEAR(hit.hit.t, 1.9 / 0.5, 1e-9);
  EXPECT_TRUE(hit.hit.normal.isApprox(Vector3d::UnitZ(), 1e-9));
  EXPECT_EQ(caster.first({{0.4, 0.4, 3}, {0, 0, -1}}).body, &bodies[1]);
  EXPECT_EQ(caster.first({{4, 0.4, 3}, {0, 0, -1}}).body, nullptr);
  const Vector3d below(centre.x(), centre.y(), 0.1);
  EXPECT_TRUE(caster.isBlocked(centre + Vector3d(0, 0, 2), below));
  EXPECT_FALSE(caster.isBlocked({0.4, 0, 2}, {0.4, 0, 0.1})) << "a surface does not block itself";
}

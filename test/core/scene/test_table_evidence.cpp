// SPDX-License-Identifier: BSD-3-Clause
// What lies under a plane speaks against its being the table.
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "scene/table_evidence.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kBoardM = 0.2;

/// A table with one box on it, and a board over its far half that carries four.
Scene tableUnderABoard() {
  Scene scene;
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.45, 0), box({-0.45, -0.25, 0}, {-0.35, -0.15, 0.1}),
                    box({-0.3, 0.0, kBoardM - 0.01}, {0.3, 0.3, kBoardM})};
  for (int k = 0; k < 4; ++k) {
    const double x = -0.28 + 0.12 * k;
    scene.surfaces.push_back(box({x, 0.06, kBoardM}, {x + 0.08, 0.14, kBoardM + 0.08}));
  }
  scene.s0 = 0.0005, scene.s2 = 0.0015;
  scene.T_world_camera = lookAt({0, -0.7, 0.7}, {0, 0.05, 0.05});
  return scene;
}

/// The horizontal plane of this height in the world.
Plane planeAt(const Scene& scene, double height_m) {
  Plane plane;
  plane.normal = scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
  plane.d = scene.T_world_camera.translation().z() - height_m;
  return plane;
}

}  // namespace

TEST(TableEvidence, AsManySamplesUnderAPlaneAsOnItLeaveAQuarterOfItsScore) {
  TableEvidence evidence;
  evidence.distance_m = 1, evidence.carried = 500, evidence.seen_m2 = 0.3, evidence.inliers = 10000;
  const double clear = evidence.score({});
  ASSERT_GT(clear, 0);
  evidence.below = 1;
  EXPECT_NEAR(evidence.score({}), clear / 4, 1e-12 * clear);
  evidence.below = 1.0 / 3;
  EXPECT_NEAR(evidence.score({}), clear / 2, 1e-12 * clear);
}

TEST(TableEvidence, CountsWhatLiesUnderAPlaneWithinItsExtent) {
  Scene scene = tableUnderABoard();
  const Frame frame = scene.render();
  const SurfaceSamples samples = sampleSurface(frame, estimateNormals(frame, {}), DepthNoise(), 40000);
  const auto belowOf = [&](double height_m) {
    const Plane plane = planeAt(scene, height_m);
    return judgeTable(samples, plane, seePlane(samples, plane), frame.camera.focal()).below;
  };
  // The camera sees the table under the front of the board, and nothing under the table.
  EXPECT_GT(belowOf(kBoardM), 0.2);
  EXPECT_LT(belowOf(0), 0.01);
}

TEST(TableEvidence, ABoardOverTheTableIsNotTheTableThoughItCarriesMore) {
  Scene scene = tableUnderABoard();
  const Frame frame = scene.render();
  const Result<Table> table = findTable(frame, estimateNormals(frame, {}), {});
  ASSERT_TRUE(table.ok()) << table.status.message;
  const Plane truth = planeAt(scene, 0);
  EXPECT_GT(table.value.normal.dot(truth.normal), std::cos(M_PI / 180));
  EXPECT_NEAR(table.value.d, truth.d, 0.003);
}

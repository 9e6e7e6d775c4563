// SPDX-License-Identifier: BSD-3-Clause
// Which of the things around a piece of floor enclose it.
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/object_points.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kRadius_m = 0.09, kFloor_m = 0.003;

/// The floor of a bowl that stands on the table.
const Surface kFloor = [](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
  const double t = (kFloor_m - o.z()) / d.z();
  const Eigen::Vector3d p = o + t * d;
  return t > 0 && std::hypot(p.x(), p.y()) < kRadius_m ? t : kMiss;
};

/// Share of the seen pixels of surface 1, which is a floor, that count as object.
double floorShare(std::vector<Surface> around) {
  Scene scene;
  scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0), kFloor};
  scene.surfaces.insert(scene.surfaces.end(), around.begin(), around.end());
  scene.s0 = 0.0002, scene.s2 = 0.0004;
  scene.T_world_camera = lookAt({0, -0.35, 0.75}, {0, 0, 0});
  const Frame frame = scene.render();
  const Normals normals = estimateNormals(frame, {});
  const Result<Table> table = findTable(frame, normals, {});
  EXPECT_TRUE(table.ok()) << table.status.message;
  const ObjectPoints points = findObjectPoints(frame, normals, table.value, {});
  int seen = 0, found = 0;
  for (int i = 0; i < frame.size(); ++i) {
    if (scene.seen[i] != 1) continue;
    ++seen;
    found += points.mask(i) != 0;
  }
  EXPECT_GT(seen, 1000);
  return static_cast<double>(found) / seen;
}

Surface block(double height_m) { return box({-0.02, -0.02, kFloor_m}, {0.02, 0.02, height_m}); }

}  // namespace

TEST(HollowFloors, BelongToTheBowlAlsoWhereSomethingLowLiesInIt) {
  const Surface wall = tube(0, 0, 0, 0.06, kRadius_m);
  EXPECT_GT(floorShare({wall}), 0.9);
  EXPECT_GT(floorShare({wall, block(0.027)}), 0.9) << "less than half the rim: it lies within";
}

TEST(HollowFloors, BelongToNothingBetweenThingsOfOtherHeights) {
  const Surface wall = tube(0, 0, 0, 0.06, kRadius_m);
  EXPECT_LT(floorShare({wall, block(0.034)}), 0.3) << "over half the rim: what encloses the floor is not one thing";
}

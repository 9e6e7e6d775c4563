// SPDX-License-Identifier: BSD-3-Clause
// Trays, totes and bins: their floors carry things as a table does, and their walls are no objects.
#include <gtest/gtest.h>

#include <cmath>

#include "common/convex_area.hpp"
#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "scene/container_walls.hpp"
#include "segments/supports.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// A rectangular tray around the origin: half of its inner sides, how its floor and its walls lie over the table.
struct Tray {
  double half_x = 0.16, half_y = 0.11, floor = 0.012, top = 0.04, thickness = 0.01;

  std::vector<Surface> surfaces() const {
    const double x = half_x + thickness, y = half_y + thickness;
    return {box({-half_x, -half_y, 0}, {half_x, half_y, floor}), box({-x, -y, 0}, {-half_x, y, top}),
            box({half_x, -y, 0}, {x, y, top}), box({-x, -y, 0}, {x, -half_y, top}), box({-x, half_y, 0}, {x, y, top})};
  }
};

constexpr int kFirst = 1, kTraySurfaces = 5;  // surface 0 is the table

/// The things stand on the floor of the tray.
Scene trayWith(const Tray& tray, const std::vector<Surface>& things) {
  Scene scene;
  scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0)};
  for (const Surface& surface : tray.surfaces()) scene.surfaces.push_back(surface);
  scene.surfaces.insert(scene.surfaces.end(), things.begin(), things.end());
  scene.s0 = 0.0002, scene.s2 = 0.0004;
  scene.T_world_camera = lookAt({0, -0.15, 0.75}, {0, 0, 0});
  return scene;
}

/// Two boxes that stand clear of each other and of the walls.
std::vector<Surface> twoBoxes(double floor) {
  return {box({-0.11, -0.05, floor}, {-0.03, 0.03, floor + 0.05}),
          box({0.03, -0.03, floor}, {0.10, 0.06, floor + 0.03})};
}

ObjectPoints pointsOf(Scene& scene, const ObjectPointsConfig& config = {}, int threads = 1) {
  const Frame frame = scene.render();
  const Normals normals = estimateNormals(frame, {});
  const Result<Table> table = findTable(frame, normals, {});
  EXPECT_TRUE(table.ok()) << table.status.message;
  return findObjectPoints(frame, normals, table.value, config, threads);
}

/// Share of the pixels of surfaces first..last that a mask holds.
double shareOf(const Scene& scene, const cv::Mat_<uchar>& mask, int first, int last) {
  int seen = 0, held = 0;
  for (std::size_t i = 0; i < scene.seen.size(); ++i) {
    if (scene.seen[i] < first || scene.seen[i] > last) continue;
    ++seen;
    held += mask(static_cast<int>(i) / mask.cols, static_cast<int>(i) % mask.cols) != 0;
  }
  return static_cast<double>(held) / std::max(1, seen);
}

}  // namespace

TEST(Containers, ThingsInATrayAreObjectsAndTheTrayCarriesThem) {
  for (const double floor : {0.002, 0.012, 0.03}) {
    Tray tray;
    tray.floor = floor;
    tray.top = floor + 0.03;
    Scene scene = trayWith(tray, twoBoxes(floor));
    const ObjectPoints points = pointsOf(scene);
    const int thing = kFirst + kTraySurfaces;
    EXPECT_GT(shareOf(scene, points.mask, thing, thing + 1), 0.93) << floor;
    EXPECT_LT(shareOf(scene, points.mask, kFirst, thing - 1), 0.03) << floor;
    EXPECT_GT(shareOf(scene, points.container, kFirst, thing - 1), 0.95) << floor;
    EXPECT_GT(shareOf(scene, points.on_table, kFirst, kFirst), 0.8) << "the floor " << floor;
    EXPECT_LT(shareOf(scene, points.container, 0, 0), 0.01) << "the table is none";
  }
}

TEST(Containers, ADeepToteKeepsItsWallsToItself) {
  Tray tote;
  tote.half_x = 0.2, tote.half_y = 0.15, tote.floor = 0.004, tote.top = 0.13;
  Scene scene = trayWith(tote, twoBoxes(tote.floor));
  scene.T_world_camera = lookAt({0, -0.02, 0.8}, {0, 0, 0});
  const ObjectPoints points = pointsOf(scene);
  const int thing = kFirst + kTraySurfaces;
  EXPECT_GT(shareOf(scene, points.mask, thing, thing + 1), 0.93);
  EXPECT_LT(shareOf(scene, points.mask, kFirst, thing - 1), 0.03);
}

TEST(Containers, WhatReachesOverTheWallIsAnObjectThereToo) {
  const Tray tray;
  const Surface tall = box({-0.22, -0.04, tray.floor}, {-0.06, 0.04, 0.12});  // through the wall: only its top counts
  Scene scene = trayWith(tray, {tall});
  const ObjectPoints points = pointsOf(scene);
  EXPECT_GT(shareOf(scene, points.mask, kFirst + kTraySurfaces, kFirst + kTraySurfaces), 0.8);
}

TEST(Containers, AreObjectsWhenTheyAreEmptyOrSmallOrOpen) {
  const Tray tray;
  Scene empty = trayWith(tray, {});
  EXPECT_GT(shareOf(empty, pointsOf(empty).mask, kFirst, kTraySurfaces), 0.85) << "nothing is in it";

  Tray dish;
  dish.half_x = dish.half_y = 0.07;
  Scene small = trayWith(dish, {box({-0.03, -0.03, dish.floor}, {0.03, 0.03, 0.05})});
  EXPECT_EQ(cv::countNonZero(pointsOf(small).container), 0) << "no larger than a plate";

  Scene open = trayWith(tray, twoBoxes(tray.floor));
  open.surfaces[kFirst + 3] = open.surfaces[kFirst + 4] = open.surfaces[kFirst + 2];  // walls left and right alone
  EXPECT_EQ(cv::countNonZero(pointsOf(open).container), 0) << "a board between two walls";
}

TEST(Containers, CanBeSwitchedOff) {
  const Tray tray;
  Scene scene = trayWith(tray, twoBoxes(tray.floor));
  ObjectPointsConfig config;
  config.containers = false;
  const ObjectPoints points = pointsOf(scene, config);
  EXPECT_EQ(cv::countNonZero(points.container), 0);
  EXPECT_GT(shareOf(scene, points.mask, kFirst, kTraySurfaces), 0.85);
}

TEST(Containers, AreTheSameWithAnyNumberOfThreads) {
  const Tray tray;
  Scene scene = trayWith(tray, twoBoxes(tray.floor));
  const ObjectPoints one = pointsOf(scene, {}, 1), four = pointsOf(scene, {}, 4);
  EXPECT_EQ(cv::countNonZero(one.mask != four.mask), 0);
  EXPECT_EQ(cv::countNonZero(one.container != four.container), 0);
  EXPECT_EQ(cv::countNonZero(one.on_table != four.on_table), 0);
}

TEST(Containers, TheBoxesOfWhatIsInThemEndOnTheFloor) {
  Tray tray;
  tray.floor = 0.03, tray.top = 0.06;
  Scene scene = trayWith(tray, twoBoxes(tray.floor));
  const Segmentation result = segment(scene.render(), Config());
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  ASSERT_EQ(result.segments.size(), 2u);
  for (const Segment& segment : result.segments) {
    EXPECT_EQ(segment.support.kind, SupportKind::kOther);
    EXPECT_NEAR(segment.support.height_m, tray.floor, 0.002);
    const Eigen::Isometry3d T_table_box = result.table.T_table_camera * segment.box.T_camera_box;
    EXPECT_NEAR(T_table_box.translation().z() - 0.5 * segment.box.size_m.z(), tray.floor, 0.003);
  }
}

TEST(Containers, WallsOfOneHeightAllAroundAreTold) {
  const std::vector<cv::Point2f> floor = {{-0.1f, -0.1f}, {0.1f, -0.1f}, {0.1f, 0.1f}, {-0.1f, 0.1f}};
  // A ring of wall points around the floor, a share of them of the given height and the rest none.
  const auto walls = [&](double share, float height_m, double others) {
    std::vector<cv::Point2f> places;
    std::vector<float> heights;
    for (int k = 0; k < 2000; ++k) {
      const double angle = 2 * M_PI * k / 2000, side = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      places.emplace_back(static_cast<float>(0.11 * std::cos(angle) / side),
                          static_cast<float>(0.11 * std::sin(angle) / side));
      heights.push_back(k < share * 2000 ? height_m : static_cast<float>(others));
    }
    return wallHeight(floor, places, heights, 0.003f);
  };
  ASSERT_TRUE(walls(1, 0.05f, 0));
  EXPECT_FLOAT_EQ(*walls(1, 0.05f, 0), 0.05f);
  EXPECT_TRUE(walls(0.85, 0.05f, 0));
  EXPECT_FALSE(walls(0.6, 0.05f, 0)) << "open on two of five sides";
  EXPECT_FALSE(walls(0.5, 0.05f, 0.2)) << "half of it is four times as high";
  EXPECT_FALSE(walls(1, 0.005f, 0)) << "no higher than noise";
}

TEST(Containers, WhatIsFarBehindTheWallsDoesNotMatter) {
  const std::vector<cv::Point2f> floor = {{-0.1f, -0.1f}, {0.1f, -0.1f}, {0.1f, 0.1f}, {-0.1f, 0.1f}};
  std::vector<cv::Point2f> places = {{1e9f, -1e9f}, {-3e4f, 60}, {std::nanf(""), 0}};
  std::vector<float> heights = {0.05f, 0.05f, 0.05f};
  EXPECT_FALSE(wallHeight(floor, places, heights, 0.003f));
  const ConvexArea area(floor);
  EXPECT_TRUE(area.contains({0, 0}, -0.004f));
  for (const auto& place : places) EXPECT_FALSE(area.contains(place, -0.004f));
}

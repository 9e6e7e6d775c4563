// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/table.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

/// Noise of a Kinect.
Scene kinectScene(std::vector<Surface> surfaces) {
  Scene scene;
  scene.surfaces = std::move(surfaces);
  scene.s0 = 0.0005, scene.s2 = 0.0015;
  return scene;
}

Result<Table> tableOf(const Frame& frame, const TableConfig& config = {}) {
  return findTable(frame, estimateNormals(frame, {}), config);
}

/// The true plane z = height of the world, seen from the camera.
void expectPlane(const Table& table, const Scene& scene, double height, double tolerance_m) {
  const Eigen::Isometry3d T_world_table = scene.T_world_camera * table.T_table_camera.inverse();
  const Eigen::Vector3d normal = T_world_table.linear().col(2);
  EXPECT_GT(normal.z(), std::cos(1.0 * M_PI / 180)) << "tilted more than one degree";
  EXPECT_GT(table.d, 0);
  // The world point under the picture's middle, over the table's plane.
  const Eigen::Vector3d middle = scene.T_world_camera.inverse() * Eigen::Vector3d(0, 0, height);
  EXPECT_NEAR(table.normal.dot(middle) + table.d, 0, tolerance_m);
  EXPECT_NEAR((table.T_table_camera * middle).z(), 0, tolerance_m);
  EXPECT_NEAR(table.normal.norm(), 1, 1e-9);
}

double areaOf(const std::vector<Eigen::Vector2d>& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return area;
}

}  // namespace

TEST(Table, FindsPlaneExtentAndNoise) {
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0), box({-0.1, -0.1, 0}, {0.1, 0, 0.12})});
  const Frame frame = scene.render();
  const Result<Table> table = tableOf(frame);
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);

  const Eigen::Isometry3d T_table_world = table.value.T_table_camera * scene.T_world_camera.inverse();
  const auto inside = [&](double x, double y) {
    const Eigen::Vector3d p = T_table_world * Eigen::Vector3d(x, y, 0);
    return table.value.extent.contains(p.x(), p.y());
  };
  EXPECT_TRUE(inside(0, 0) && inside(-0.38, -0.28) && inside(0.38, 0.28)) << "the place under the box as well";
  EXPECT_FALSE(inside(0.5, 0) || inside(-0.5, 0) || inside(0, 0.7));
  EXPECT_NEAR(areaOf(table.value.hull), 0.8 * 0.6, 0.01) << "counter-clockwise: positive";
  EXPECT_NEAR(table.value.noise.sigma(1.05), scene.s0 + scene.s2 * 1.05 * 1.05, 0.0007);
}

TEST(Table, EmptyTableIsATable) {
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0)});
  const Result<Table> table = tableOf(scene.render());
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);
}

TEST(Table, TakesTheOneThatCarriesThingsNotTheLargerFloor) {
  Scene scene =
      kinectScene({slab(-3, -3, 3, 3, -0.7), slab(-0.3, -0.2, 0.3, 0.2, 0), box({-0.1, -0.05, 0}, {0, 0.05, 0.1})});
  scene.T_world_camera = lookAt({0, -0.9, 0.8}, {0, 0.2, -0.1});
  const Frame frame = scene.render();
  ASSERT_GT(std::count(scene.seen.begin(), scene.seen.end(), 0),
            2 * std::count(scene.seen.begin(), scene.seen.end(), 1));
  const Result<Table> table = tableOf(frame);
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);
  EXPECT_FALSE(table.value.other_planes.empty()) << "the floor is known, as no table";
}

TEST(Table, IsNotTheFloorThatATableStandsOnByOneFoot) {
  // With its foot in view the table top is a thing that the floor carries, the largest of all.
  struct Pose {
    double x, y, z, height_m;
  };
  for (const Pose& at : {Pose{0, -1.1, 0.5, 0.73},
                         {0.5, -1.2, 0.6, 0.73},
                         {-0.6, -1.2, 0.9, 0.73},
                         {0, -1, 0.7, 0.45},
                         {0.7, -1.1, 0.8, 0.45},
                         {0, -1.3, 0.5, 0.9}}) {
    Scene scene = kinectScene({slab(-4, -4, 4, 4, -at.height_m), slab(-0.45, -0.3, 0.45, 0.3, 0),
                               tube(0, 0, -at.height_m, 0, 0.05), box({-0.1, -0.1, 0}, {0, 0, 0.1})});
    scene.T_world_camera = lookAt({at.x, at.y, at.z}, {0, 0, -0.1});
    const Frame frame = scene.render();
    ASSERT_GT(std::count(scene.seen.begin(), scene.seen.end(), 2), 300) << "the foot must be seen";
    const Result<Table> table = tableOf(frame);
    ASSERT_TRUE(table.ok()) << table.status.message;
    SCOPED_TRACE(testing::Message() << "camera at " << at.x << ", " << at.y << ", " << at.z);
    expectPlane(table.value, scene, 0, 0.003);
  }
}

TEST(Table, TakesTheTableNotTheBoxTop) {
  Scene scene = kinectScene({slab(-0.4, -0.35, 0.4, 0.35, 0), box({-0.25, -0.2, 0}, {0.25, 0.2, 0.1})});
  const Result<Table> table = tableOf(scene.render());
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);
}

TEST(Table, LiesUnderTheBooksThatHideMostOfIt) {
  // Two books of 9 mm show more surface than the table between them.
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0), box({-0.38, -0.28, 0}, {-0.03, 0.28, 0.009}),
                             box({0.03, -0.28, 0}, {0.3, 0.28, 0.009})});
  const Frame frame = scene.render();
  const Result<Table> table = tableOf(frame);
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.003);
}

TEST(Table, WorksUpsideDown) {
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0), box({-0.1, -0.1, 0}, {0.1, 0, 0.12})});
  scene.T_world_camera.linear().col(0) *= -1;
  scene.T_world_camera.linear().col(1) *= -1;
  const Result<Table> table = tableOf(scene.render());
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);
}

TEST(Table, GivenPlaneIsUsedAndTurnedToTheCamera) {
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0), box({-0.3, -0.25, 0}, {0.3, 0.25, 0.1})});
  const Frame frame = scene.render();
  const Eigen::Vector3d up = scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
  const double d = scene.T_world_camera.translation().z() - 0.1;  // the box top
  for (const double scale : {1.0, -3.0}) {
    TableConfig config;
    config.given = true;
    config.given_a = scale * up.x(), config.given_b = scale * up.y(), config.given_c = scale * up.z();
    config.given_d = scale * d;
    const Result<Table> table = tableOf(frame, config);
    ASSERT_TRUE(table.ok()) << table.status.message;
    expectPlane(table.value, scene, 0.1, 1e-6);
    EXPECT_NEAR(areaOf(table.value.hull), 0.6 * 0.5, 0.01);
  }
}

TEST(Table, GivenPlaneErrors) {
  Scene scene = kinectScene({slab(-0.4, -0.3, 0.4, 0.3, 0)});
  const Frame frame = scene.render();
  TableConfig config;
  config.given = true;
  EXPECT_EQ(tableOf(frame, config).status.code, StatusCode::kBadConfig);
  config.given_c = -1, config.given_d = 5;
  EXPECT_EQ(tableOf(frame, config).status.code, StatusCode::kNoTable) << "nothing lies on it";
}

TEST(Table, UpDirectionExcludesWalls) {
  // A wall with a shelf-like box on it, larger than the table in view.
  Scene scene = kinectScene(
      {slab(-0.5, -0.2, 0.5, 0.2, 0), box({-1, 0.2, -1}, {1, 0.3, 1}), box({-0.1, 0.1, 0.3}, {0.1, 0.2, 0.5})});
  const Frame frame = scene.render();
  const Eigen::Vector3d up = scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
  TableConfig config;
  config.up_known = true;
  config.up_x = 2 * up.x(), config.up_y = 2 * up.y(), config.up_z = 2 * up.z();
  const Result<Table> table = tableOf(frame, config);
  ASSERT_TRUE(table.ok()) << table.status.message;
  expectPlane(table.value, scene, 0, 0.002);

  config.up_x = -up.x(), config.up_y = -up.y(), config.up_z = -up.z();
  const Result<Table> none = tableOf(frame, config);
  EXPECT_EQ(none.status.code, StatusCode::kNoTable);
  EXPECT_NE(none.status.message.find("max_tilt_deg"), std::string::npos) << none.status.message;
  config.up_x = config.up_y = config.up_z = 0;
  EXPECT_EQ(tableOf(frame, config).status.code, StatusCode::kBadConfig);
}

TEST(Table, NoPlaneSaysWhatWasSeen) {
  Scene ball = kinectScene({sphere({0, 0, 0.1}, 0.1)});
  for (const Frame& frame : {ball.render(), kinectScene({}).render()}) {
    const Result<Table> table = tableOf(frame);
    EXPECT_EQ(table.status.code, StatusCode::kNoTable);
    EXPECT_NE(table.status.message.find("% of the pixels have depth"), std::string::npos) << table.status.message;
  }
  Frame pixel;
  pixel.camera = {500, 500, 0, 0, 1, 1};
  pixel.points = {Eigen::Vector3f(0, 0, 1)};
  EXPECT_EQ(tableOf(pixel).status.code, StatusCode::kNoTable);
  pixel.points[0].setConstant(kNan);
  EXPECT_EQ(tableOf(pixel).status.code, StatusCode::kNoTable);
}

TEST(Table, TooSmallIsNoTable) {
  Scene scene = kinectScene({slab(-0.05, -0.05, 0.05, 0.05, 0)});
  const Result<Table> table = tableOf(scene.render());
  EXPECT_EQ(table.status.code, StatusCode::kNoTable);
  EXPECT_NE(table.status.message.find("table.min_area_m2"), std::string::npos) << table.status.message;
}

TEST(Table, SameTwice) {
  Scene scene =
      kinectScene({slab(-3, -3, 3, 3, -0.7), slab(-0.4, -0.3, 0.4, 0.3, 0), box({-0.1, -0.1, 0}, {0.1, 0, 0.12})});
  const Frame frame = scene.render();
  const Result<Table> a = tableOf(frame), b = tableOf(frame);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a.value.normal, b.value.normal);
  EXPECT_EQ(a.value.d, b.value.d);
  EXPECT_EQ(a.value.noise.quadratic_per_m, b.value.noise.quadratic_per_m);
  EXPECT_EQ(a.value.hull, b.value.hull);
  EXPECT_EQ(a.value.hull_measured, b.value.hull_measured);
  EXPECT_EQ(cv::norm(a.value.extent.cells, b.value.extent.cells, cv::NORM_INF), 0);
}

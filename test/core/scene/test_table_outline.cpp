// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/table.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kStepM = 0.005;

/// How far a place of the plane lies beyond the edge of a table top; negative: inside.
double beyond(const sim::TableSize& table, const Vector2d& p) {
  if (table.round) return p.norm() - table.width_m / 2;
  const Vector2d over(std::abs(p.x()) - table.width_m / 2, std::abs(p.y()) - table.depth_m / 2);
  return over.maxCoeff() <= 0 ? over.maxCoeff() : over.cwiseMax(0).norm();
}

/// Places on its edge, a step apart, each with the direction out of it.
std::vector<std::pair<Vector2d, Vector2d>> edgeOf(const sim::TableSize& table) {
  std::vector<std::pair<Vector2d, Vector2d>> edge;
  if (table.round) {
    for (double angle = 0; angle < 2 * M_PI; angle += kStepM / (table.width_m / 2)) {
      const Vector2d out(std::cos(angle), std::sin(angle));
      edge.emplace_back(table.width_m / 2 * out, out);
    }
    return edge;
  }
  for (const int axis : {0, 1}) {
    const double half = 0.5 * (axis == 0 ? table.depth_m : table.width_m);
    const double along = 0.5 * (axis == 0 ? table.width_m : table.depth_m);
    for (const int side : {-1, 1}) {
      for (double at = -along; at <= along; at += kStepM) {
        Vector2d p, out = Vector2d::Zero();
        p[axis] = at, p[1 - axis] = side * half, out[1 - axis] = side;
        edge.emplace_back(p, out);
      }
    }
  }
  return edge;
}

/// Pixel that sees a place of the table's plane; false out of the picture.
bool pixelOf(const sim::SimulatedFrame& frame, const Vector2d& place, cv::Point& pixel) {
  const Vector3d p = frame.T_world_camera.inverse() * Vector3d(place.x(), place.y(), 0);
  if (!(p.z() > 0)) return false;
  const Vector2d at = frame.images.camera.project(p);
  pixel = {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  return cv::Rect(1, 1, frame.images.camera.width - 2, frame.images.camera.height - 2).contains(pixel);
}

/// Whether the picture shows the table inside of a place of its edge, and what is behind it outside.
bool isSeen(const sim::SimulatedFrame& frame, const Vector2d& place, const Vector2d& out) {
  cv::Point pixel;
  for (const double inside : {0.01, 0.03}) {
    if (!pixelOf(frame, place - inside * out, pixel) || frame.images.true_labels(pixel) != 1) return false;
  }
  for (const double outside : {0.02, 0.03}) {
    if (!pixelOf(frame, place + outside * out, pixel)) return false;
    if (frame.images.true_labels(pixel) != 0 || frame.images.depth_mm(pixel) == 0) return false;
  }
  return true;
}

double distanceToSide(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double length = (b - a).norm();
  const double at = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, length) : 0;
  return (p - a - (length > 0 ? at / length : 0) * (b - a)).norm();
}

/// How an outline agrees with the true one.
struct Agreement {
  std::vector<double> errors;         ///< of places on measured sides, from the true edge
  std::size_t seen = 0, covered = 0;  ///< places of the true edge that are seen; that lie near a measured side
  double farthest_beyond = -1;        ///< of any place of the outline

  void add(const Agreement& other) {
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
    seen += other.seen;
    covered += other.covered;
    farthest_beyond = std::max(farthest_beyond, other.farthest_beyond);
  }
  double errorOf(double share) {
    std::sort(errors.begin(), errors.end());
    return errors[static_cast<std::size_t>(share * (errors.size() - 1))];
  }
};

constexpr double kNearM = 0.01;

Agreement compare(const sim::SimulatedFrame& frame, const Table& table, const sim::TableSize& size) {
  std::vector<Vector2d> corners;
  for (const Vector2d& p : table.hull) {
    const Vector3d at = frame.T_world_camera * table.T_table_camera.inverse() * Vector3d(p.x(), p.y(), 0);
    corners.push_back(at.head<2>());
  }
  Agreement agreement;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d &a = corners[i], &b = corners[(i + 1) % count];
    for (double at = 0; at < (b - a).norm(); at += kStepM) {
      const double error = beyond(size, a + at * (b - a).normalized());
      if (table.hull_measured[i]) agreement.errors.push_back(std::abs(error));
      agreement.farthest_beyond = std::max(agreement.farthest_beyond, error);
    }
  }
  for (const auto& [place, out] : edgeOf(size)) {
    if (!isSeen(frame, place, out)) continue;
    ++agreement.seen;
    bool near = false;
    for (std::size_t i = 0; i < count && !near; ++i) {
      near = table.hull_measured[i] && distanceToSide(place, corners[i], corners[(i + 1) % count]) < kNearM;
    }
    agreement.covered += near;
  }
  return agreement;
}

const std::vector<sim::TableSize>& tables() {
  static const std::vector<sim::TableSize> all{
      {false, 0.4, 0.3, 0.5},  {false, 0.6, 0.4, 0.45}, {false, 0.9, 0.6, 0.73},
      {false, 1.2, 0.8, 0.72}, {false, 1.8, 1.0, 0.9},  {true, 0.4, 0.4, 0.5},
      {true, 0.7, 0.7, 0.45},  {true, 1.1, 1.1, 0.72},  {true, 1.3, 1.3, 0.73}};
  return all;
}

/// With the true plane given: which plane is the table is tested elsewhere.
Result<Table> tableOf(const sim::SimulatedFrame& frame) {
  const Frame seen = makeFrame(frame.images.depth_mm, cv::Mat(), frame.images.camera, InputConfig()).value;
  TableConfig config;
  config.given = true;
  config.given_a = frame.table_normal.x(), config.given_b = frame.table_normal.y();
  config.given_c = frame.table_normal.z(), config.given_d = frame.table_distance_m;
  return findTable(seen, estimateNormals(seen, {}), config);
}

/// All tables, each with several views and things on it.
Agreement compareAll(const sim::DepthSensor& sensor) {
  Agreement all;
  for (std::size_t k = 0; k < tables().size(); ++k) {
    const sim::TableSize& size = tables()[k];
    for (std::uint32_t index = 0; index < 3; ++index) {
      sim::SceneRequest request;
      request.level = index == 2 ? "clutter" : "boxes";
      request.seed = 5;
      request.index = 10 * static_cast<std::uint32_t>(k) + index;
      request.objects = size.width_m < 0.5 ? 1 : 3;
      request.table = size;
      request.camera = sensor.camera;
      const auto scene = sim::generateScene(request);
      EXPECT_TRUE(scene.ok()) << scene.status.message;
      if (!scene.ok()) continue;
      const auto frame = sim::simulateFrame(scene.value, scene.value.T_world_camera, sensor, 1);
      const Result<Table> table = tableOf(frame);
      EXPECT_TRUE(table.ok()) << table.status.message;
      if (!table.ok()) continue;
      EXPECT_EQ(table.value.hull.size(), table.value.hull_measured.size());
      all.add(compare(frame, table.value, size));
    }
  }
  return all;
}

}  // namespace

TEST(TableOutline, IsTheTrueEdgeWhereThatIsSeen) {
  sim::DepthSensor sensor;
  sensor.ideal = true;
  Agreement all = compareAll(sensor);
  ASSERT_GT(all.seen, 5000u);
  EXPECT_LT(all.errorOf(0.95), 0.004);
  EXPECT_LT(all.errorOf(0.999), 0.010);
  EXPECT_GT(all.covered, 0.99 * all.seen);
  EXPECT_LT(all.farthest_beyond, 0.012) << "nor does what is inferred reach beyond the table";
}

TEST(TableOutline, IsTheTrueEdgeDespiteNoise) {
  for (const bool stereo : {false, true}) {
    sim::DepthSensor sensor;
    if (stereo) sensor = sim::DepthSensor::stereo(sensor.camera);
    Agreement all = compareAll(sensor);
    SCOPED_TRACE(stereo ? "stereo" : "structured light");
    ASSERT_GT(all.seen, 3000u);
    EXPECT_LT(all.errorOf(0.5), 0.004);
    EXPECT_LT(all.errorOf(stereo ? 0.8 : 0.95), 0.010) << "stereo rounds edges by its matching window";
    EXPECT_GT(all.covered, (stereo ? 0.8 : 0.95) * all.seen);
  }
}

TEST(TableOutline, OfATableThatIsWhollySeenEverySideIsMeasured) {
  objectness_test::Scene scene;
  scene.surfaces = {objectness_test::slab(-3, -3, 3, 3, -0.7), objectness_test::slab(-0.3, -0.2, 0.3, 0.2, 0)};
  scene.T_world_camera = objectness_test::lookAt({0.2, -0.6, 0.8}, {0, 0, 0});
  const Frame frame = scene.render();
  const Result<Table> table = findTable(frame, estimateNormals(frame, {}), {});
  ASSERT_TRUE(table.ok()) << table.status.message;
  ASSERT_EQ(table.value.hull.size(), 4u);
  EXPECT_EQ(table.value.hull_measured, std::vector<char>(4, 1));
  for (const Vector2d& p : table.value.hull) {
    const Vector3d corner = scene.T_world_camera * table.value.T_table_camera.inverse() * Vector3d(p.x(), p.y(), 0);
    EXPECT_NEAR(std::abs(corner.x()), 0.3, 0.003);
    EXPECT_NEAR(std::abs(corner.y()), 0.2, 0.003);
  }
}

TEST(TableOutline, WhatIsHiddenOrBeyondThePictureIsNotMeasured) {
  // The table goes on beyond the picture to the left; a box stands on its right edge, at the near end of it.
  objectness_test::Scene scene;
  scene.surfaces = {objectness_test::slab(-4, -4, 4, 4, -0.7), objectness_test::slab(-2, -0.25, 0.3, 0.25, 0),
                    objectness_test::box({0.15, -0.25, 0}, {0.3, -0.1, 0.15})};
  const Frame frame = scene.render();
  const Result<Table> table = findTable(frame, estimateNormals(frame, {}), {});
  ASSERT_TRUE(table.ok()) << table.status.message;
  double measured = 0, others = 0;
  const auto& hull = table.value.hull;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    Vector3d ends[2];
    for (const std::size_t k : {0u, 1u}) {
      const Vector2d& p = hull[(i + k) % hull.size()];
      ends[k] = scene.T_world_camera * table.value.T_table_camera.inverse() * Vector3d(p.x(), p.y(), 0);
    }
    const Vector3d middle = 0.5 * (ends[0] + ends[1]);
    const double length = (ends[1] - ends[0]).norm();
    (table.value.hull_measured[i] ? measured : others) += length;
    if (length < 0.03) continue;
    const bool at_true_edge =
        std::abs(std::abs(middle.y()) - 0.25) < 0.01 || (std::abs(middle.x() - 0.3) < 0.01 && middle.y() > -0.1);
    const bool by_the_box = middle.x() > 0.13 && middle.y() < -0.08;
    EXPECT_EQ(table.value.hull_measured[i] != 0, at_true_edge && !by_the_box)
        << ends[0].transpose() << " to " << ends[1].transpose();
  }
  EXPECT_GT(measured, 1.2);
  EXPECT_GT(others, 0.5);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/true_labels.hpp"
#include "fixtures/generated_scene.hpp"
#include "fixtures/surface_points.hpp"
#include "sim/scene_generator.hpp"

using namespace objectness;
using namespace objectness::sim;
using namespace objectness_test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kScenes = 100;  // of each level
constexpr int kRaysABody = 100;
constexpr double kDeep_m = 1e-5;     // under the surface: what touches is not that deep in its neighbour
constexpr double kContact_m = 1e-3;  // what is farther from its support floats

bool leans(const SceneObject& object) { return object.T_world_box.linear()(2, 2) < 1 - 1e-9; }
bool standsOnTable(const SceneObject& object) {
  return leans(object) || std::abs(object.T_world_box.translation().z() - object.size_m.z() / 2) < 1e-9;
}

/// What the things stand on: the table, or a tray, tote or shelf on it.
bool isOnSupport(const Scene& scene, const Vector3d& position) {
  const int label = findLevel(scene.level)->stage == StageKind::kTable ? 1 : kStageLabel;
  return isIn(withLabel(scene, label), {position.x(), position.y(), -0.001});
}

const Body& tableOf(const Scene& scene) {
  return *std::find_if(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.label == 1; });
}

/// An upright thing's outline seen from above, without its handle: a disc, or a rectangle's corners in order.
struct Outline {
  std::vector<Vector2d> corners;
  double radius = 0;

  double distance(const Vector2d& p) const {  // 0 within
    if (radius > 0) return std::max(0.0, (p - corners[0]).norm() - radius);
    double nearest = 1e9;
    bool within = true;
    for (int i = 0; i < 4; ++i) {
      const Vector2d a = corners[i], along = corners[(i + 1) % 4] - a, to = p - a;
      const double share = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (to - share * along).norm());
      within &= along.x() * to.y() - along.y() * to.x() >= 0;
    }
    return within ? 0 : nearest;
  }
};

Outline outlineOf(const Body& body) {
  const Vector2d centre = body.T_world_body.translation().head<2>();
  const Eigen::AlignedBox3d box = bounds(body.shape);
  if (!std::holds_alternative<sim::Box>(body.shape)) return {{centre}, box.max().x()};
  Outline outline;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    outline.corners.push_back((body.T_world_body * Vector3d(x * box.max().x(), y * box.max().y(), 0)).head<2>());
  }
  return outline;
}

/// Of two outlines that do not overlap.
double distance(const Outline& a, const Outline& b) {
  double nearest = 1e9;
  for (const Vector2d& corner : a.corners) nearest = std::min(nearest, b.distance(corner) - a.radius);
  for (const Vector2d& corner : b.corners) nearest = std::min(nearest, a.distance(corner) - b.radius);
  return nearest;
}

class EveryLevel : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(EveryLevel, NothingInterpenetratesAndNothingFloats) {
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request(GetParam(), index));
    std::set<int> supported;
    for (const SurfacePoint& point : surfacePoints(scene, kRaysABody)) {
      EXPECT_GE(point.position.z(), -1e-9) << "in the table";
      const Vector3d deep = point.position - kDeep_m * point.normal;
      if (!point.normal.isZero()) {
        EXPECT_FALSE(objectAt(scene, deep, point.label)) << "scene " << index << ", object " << point.label;
      }
      const Vector3d lower = point.position - kContact_m * Vector3d::UnitZ();
      if (lower.z() < 0 || objectAt(scene, lower, point.label)) supported.insert(point.label);
    }
    for (const SceneObject& object : scene.objects) {
      EXPECT_TRUE(supported.count(object.label)) << "scene " << index << ": the " << object.kind << " floats";
    }
  }
}

TEST_P(EveryLevel, EverythingIsOverTheTableAndInThePicture) {
  for (int index = 0; index < kScenes; ++index) {
    const SceneRequest asked = request(GetParam(), index);
    const Scene scene = generate(asked);
    const ViewRange& view = findLevel(scene.level)->view;
    const Eigen::Isometry3d T_camera_world = scene.T_world_camera.inverse();
    for (const SurfacePoint& point : surfacePoints(scene, 30)) {
      EXPECT_TRUE(isOnSupport(scene, point.position)) << "scene " << index;
      const Vector2d pixel = asked.camera.project(T_camera_world * point.position);
      EXPECT_TRUE(pixel.x() > 0 && pixel.x() < 639 && pixel.y() > 0 && pixel.y() < 479) << "scene " << index;
    }
    const double height = scene.T_world_camera.translation().z();
    const double away = (scene.T_world_camera.translation() - scene.target).norm();
    EXPECT_GE(away, kMinDistance_m - 1e-9);
    EXPECT_LE(away, kMaxDistance_m + 1e-9);
    const double tilt_deg = std::asin((height - scene.target.z()) / away) * 180 / 3.14159265358979;
    EXPECT_GE(tilt_deg, view.min_tilt_deg - 1e-6);
    EXPECT_LE(tilt_deg, view.max_tilt_deg + 1e-6);
  }
}

TEST_P(EveryLevel, HasHouseholdSizesAndItsNumberOfThings) {
  std::set<std::string> kinds;
  const Level& level = *findLevel(GetParam());
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request(GetParam(), index));
    EXPECT_GE(static_cast<int>(scene.objects.size()), level.min_objects);
    EXPECT_LE(static_cast<int>(scene.objects.size()), level.max_objects);
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
      const SceneObject& object = scene.objects[k];
      EXPECT_EQ(object.label, 20 + 10 * static_cast<int>(k));
      EXPECT_GE(object.size_m.maxCoeff(), 0.04);
      EXPECT_LE(object.size_m.maxCoeff(), 0.3);
      kinds.insert(object.kind);
    }
  }
  std::set<std::string> drawn_from(level.kinds.begin(), level.kinds.end());
  drawn_from.insert(level.fillings.begin(), level.fillings.end());
  EXPECT_EQ(kinds, drawn_from);
}

TEST_P(EveryLevel, TakesAnyNumberOfObjects) {
  for (const int objects : {0, 1, 2, 12, kMaxObjects}) {
    SceneRequest asked = request(GetParam(), 3);
    asked.objects = objects;
    EXPECT_EQ(static_cast<int>(generate(asked).objects.size()), objects);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, EveryLevel, testing::ValuesIn(levelsThat([](const Level&) { return true; })),
                         [](const auto& info) { return info.param; });

TEST(SceneGenerator, ThingsTouchAtTheTouchingLevelAndStandApartAtOthers) {
  for (const auto& [level, least, most] :
       {std::tuple("touching", 0.0, 0.002), {"boxes", 0.03, 1.0}, {"shapes", 0.03, 1.0}}) {
    for (int index = 0; index < kScenes; ++index) {
      const Scene scene = generate(request(level, index));
      double nearest = 1e9;
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          const Body &a = scene.bodies[i], &b = scene.bodies[k];
          if (a.label < 20 || b.label < 20 || a.label == b.label || std::holds_alternative<Tube>(a.shape) ||
              std::holds_alternative<Tube>(b.shape)) {
            continue;
          }
          nearest = std::min(nearest, distance(outlineOf(a), outlineOf(b)));
        }
      }
      EXPECT_GE(nearest, least - 1e-9) << level << " " << index;
      EXPECT_LE(nearest, most + 1e-9) << level << " " << index;
    }
  }
}

TEST(SceneGenerator, ThingsAreStackedAtTheStackedLevel) {
  int stacked = 0, all = 0;
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request("stacked", index));
    const auto on_things = std::count_if(scene.objects.begin(), scene.objects.end(),
                                         [](const SceneObject& object) { return !standsOnTable(object); });
    EXPECT_GE(on_things, 1) << "scene " << index;
    stacked += on_things;
    all += scene.objects.size();
  }
  EXPECT_GT(stacked, all / 3);
}

TEST(SceneGenerator, SlabsLeanAtAThing) {
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request("leaning", index));
    std::set<int> leaning, touching, on_table;
    for (const SceneObject& object : scene.objects) {
      if (leans(object)) leaning.insert(object.label);
    }
    EXPECT_FALSE(leaning.empty()) << "scene " << index;
    for (const SurfacePoint& point : surfacePoints(scene, 0)) {
      if (!leaning.count(point.label)) continue;
      if (std::abs(point.position.z()) < 1e-9) on_table.insert(point.label);
      if (!point.normal.isZero() && objectAt(scene, point.position + kContact_m * point.normal, point.label)) {
        touching.insert(point.label);
      }
    }
    EXPECT_EQ(on_table, leaning) << "scene " << index << ": the lower edge stands on the table";
    EXPECT_EQ(touching, leaning) << "scene " << index << ": the face or the upper edge touches a support";
  }
}

TEST(SceneGenerator, ASceneDependsOnSeedLevelAndIndexAlone) {
  const auto poses = [](const Scene& scene) {
    std::vector<double> numbers{scene.T_world_camera.translation().x(), scene.T_world_camera.translation().y()};
    for (const Body& body : scene.bodies) {
      numbers.insert(numbers.end(), body.T_world_body.data(), body.T_world_body.data() + 16);
      numbers.push_back(body.color[0]);
    }
    return numbers;
  };
  std::set<std::vector<double>> different;
  int scenes = 0;
  for (const Level& level : levels()) {
    for (const std::uint32_t seed : {1, 2}) {
      for (const std::uint32_t index : {0, 1, 1999}) {
        SceneRequest asked = request(level.name, index);
        asked.seed = seed;
        EXPECT_EQ(poses(generate(asked)), poses(generate(asked)));
        different.insert(poses(generate(asked)));
        ++scenes;
      }
    }
  }
  EXPECT_EQ(static_cast<int>(different.size()), scenes);
}

TEST(SceneGenerator, TakesTableAndCameraAsGiven) {
  SceneRequest asked = request("shapes", 0);
  asked.table = TableSize{true, 1.0, 1.0, 0.5};
  asked.T_world_camera = lookAt({0.3, -0.8, 0.6}, {0, 0, 0});
  const Scene scene = generate(asked);
  EXPECT_TRUE(scene.T_world_camera.isApprox(*asked.T_world_camera));
  EXPECT_NEAR(bounds(tableOf(scene).shape).sizes().x(), 1.0, 1e-12);
  EXPECT_NEAR(scene.bodies.front().T_world_body.translation().z(), -0.51, 1e-12) << "the floor";
}

TEST(SceneGenerator, SaysWhyThereIsNoScene) {
  const auto expectError = [](const SceneRequest& asked, const std::string& text) {
    const Result<Scene> scene = generateScene(asked);
    EXPECT_EQ(scene.status.code == StatusCode::kBadConfig || scene.status.code == StatusCode::kBadCamera, true);
    EXPECT_NE(scene.status.message.find(text), std::string::npos) << scene.status.message;
  };
  SceneRequest asked = request("chaos", 0);
  expectError(asked, "no level 'chaos', but boxes, shapes");
  asked = request("boxes", 0);
  asked.objects = kMaxObjects + 1;
  expectError(asked, "must be 0 to 40");
  asked.objects = 20;
  asked.table = TableSize{false, 0.4, 0.4, 0.7};
  expectError(asked, "no room for 20 objects");
  asked = request("boxes", 0);
  asked.camera = {};
  expectError(asked, "");
  asked = request("boxes", 0);
  asked.T_world_camera = lookAt({0, -1, 0.5}, {0, 0, 1});
  expectError(asked, "must look down");
}

TEST(TableSize, IsReadFromText) {
  const Result<TableSize> square = parseTable("1.2x0.8x0.72"), round = parseTable("round:1.1x0.5");
  ASSERT_TRUE(square.ok() && round.ok());
  EXPECT_EQ(square.value.depth_m, 0.8);
  EXPECT_EQ(square.value.height_m, 0.72);
  EXPECT_TRUE(round.value.round);
  EXPECT_EQ(round.value.depth_m, 1.1);
  for (const char* wrong :
       {"", "1.2", "1.2x0.8", "1.2x0.8x0.72x1", "1.2,0.8,0.7", "round:1.1", "0.1x1x0.7", "1x1x9", "-1x1x1"}) {
    EXPECT_FALSE(parseTable(wrong).ok()) << wrong;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/angles.hpp"
#include "common/true_labels.hpp"
#include "fixtures/generated_scene.hpp"
#include "fixtures/surface_points.hpp"
#include "sim/intersect.hpp"
#include "sim/lenses.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using namespace objectness::sim;
using namespace objectness_test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kScenes = 40;       // of each level
constexpr double kDeep_m = 1e-5;  // under a surface

double baseOf(const SceneObject& object) { return object.T_world_box.translation().z() - object.size_m.z() / 2; }
double topOf(const SceneObject& object) { return object.T_world_box.translation().z() + object.size_m.z() / 2; }
Vector2d placeOf(const SceneObject& object) { return object.T_world_box.translation().head<2>(); }

class EverydayLevel : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(EverydayLevel, NothingIsInATrayAWallOrAnArm) {
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request(GetParam(), index));
    std::vector<Body> background, around = withLabel(scene, kAroundLabel);
    for (const Body& body : scene.bodies) {
      if (body.label < kFirstTrueLabel) background.push_back(body);
    }
    for (const SurfacePoint& point : surfacePoints(scene, 60)) {
      if (point.normal.isZero()) continue;
      const Vector3d deep = point.position - kDeep_m * point.normal;
      EXPECT_FALSE(isIn(background, deep)) << "scene " << index << ", object " << point.label;
    }
    // Points of the surroundings, as if they were objects: in no object, and not in the table or what stands on it.
    Scene alone = scene;
    alone.bodies = around;
    for (Body& body : alone.bodies) body.label = kFirstTrueLabel;
    std::vector<Body> others = withLabel(scene, 1);
    for (const Body& body : withLabel(scene, kStageLabel)) others.push_back(body);
    for (const SurfacePoint& point : surfacePoints(alone, 60)) {
      EXPECT_FALSE(objectAt(scene, point.position, 0)) << "scene " << index;
      EXPECT_FALSE(isIn(others, point.position)) << "scene " << index;
    }
  }
}

TEST_P(EverydayLevel, LabelsAreThoseOfTheNearestBodyOnEveryRay) {
  DepthSensor sensor;
  sensor.ideal = true;
  sensor.camera = {78.75, 78.75, 47.5, 35.5, 96, 72};
  for (int index = 0; index < 3; ++index) {
    SceneRequest asked = request(GetParam(), index);
    asked.camera = sensor.camera;
    asked.around = Surroundings{index == 0, index == 1, index == 1, index == 2};
    const Scene scene = generate(asked);
    const SimulatedFrame frame = simulateFrame(scene, scene.T_world_camera, sensor, 1);
    std::set<int> hidden;
    for (const TrueObject& object : frame.objects) {
      if (object.hidden) hidden.insert(object.label);
    }
    for (int v = 0; v < 72; ++v) {
      for (int u = 0; u < 96; ++u) {
        const Eigen::Isometry3d& pose = scene.T_world_camera;
        double nearest = 1e9;
        int label = 0;
        for (const Body& body : scene.bodies) {
          const Eigen::Isometry3d T_body_world = body.T_world_body.inverse();
          const Vector3d direction = pose.linear() * sensor.camera.ray(u, v);
          const auto hit =
              intersect(body.shape, {T_body_world * pose.translation(), T_body_world.linear() * direction});
          if (hit && hit->t < nearest - 1e-9) nearest = hit->t, label = body.label;
        }
        if (nearest == 1e9 || nearest > 65.5) continue;
        ASSERT_EQ(frame.images.true_labels(v, u), hidden.count(label) ? 0 : label) << "pixel " << u << ", " << v;
        ASSERT_NEAR(frame.images.depth_mm(v, u), 1000 * nearest, 0.51);
      }
    }
  }
}

TEST_P(EverydayLevel, EveryLensSeesAsMuchOfEveryThingAsTheLevelPromises) {
  for (const Lens& lens : lenses()) {
    SceneRequest asked = request(GetParam(), 5);
    asked.camera = lens.camera;
    const Scene scene = generate(asked);
    PinholeCamera camera = lens.camera;  // no finer than it has to be for shares
    while (camera.width > 400) {
      camera = {camera.fx / 2,         camera.fy / 2,    (camera.cx - 0.5) / 2,
                (camera.cy - 0.5) / 2, camera.width / 2, camera.height / 2};
    }
    const SurfaceView view = viewSurfaces(scene.bodies, scene.T_world_camera, camera, {});
    for (const SceneObject& object : scene.objects) {
      ASSERT_GT(view.pixels_alone.at(object.label), 0) << lens.name;
      const double visible =
          static_cast<double>(view.pixels_seen.at(object.label)) / view.pixels_alone.at(object.label);
      // The generator measured it on 96 pixels of width.
      EXPECT_GT(visible, 0.6 * findLevel(GetParam())->min_visible) << lens.name << " " << object.kind;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, EverydayLevel,
                         testing::ValuesIn(levelsThat([](const Level& level) { return level.everyday; })),
                         [](const auto& info) { return info.param; });

TEST(EverydayLevels, PlatesAreLowThings) {
  int low = 0, all = 0;
  for (int index = 0; index < kScenes; ++index) {
    for (const SceneObject& object : generate(request("plates", index)).objects) {
      low += object.size_m.z() < 0.036;
      ++all;
      EXPECT_LT(object.size_m.z(), 0.09) << object.kind;
    }
  }
  EXPECT_GT(low, 0.7 * all);
}

TEST(EverydayLevels, ThingsLieWithinTheWallsOfTraysAndTotesAndShelves) {
  for (const char* level : {"tray", "tote", "shelf"}) {
    const bool shelf = std::string(level) == "shelf";
    for (int index = 0; index < kScenes; ++index) {
      const Scene scene = generate(request(level, index));
      const std::vector<Body> walls = withLabel(scene, kStageLabel);
      ASSERT_FALSE(walls.empty());
      const Eigen::Matrix3d R_world_stage = walls.front().T_world_body.linear();
      const RayCaster caster(walls);
      for (const SceneObject& object : scene.objects) {
        const Vector3d low(placeOf(object).x(), placeOf(object).y(), 0.01);
        for (const Vector3d& way : {Vector3d(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
          const bool open = shelf && way.y() < 0;  // the front
          EXPECT_EQ(caster.first({low, R_world_stage * way}).body != nullptr, !open) << level << " " << index;
        }
        const SceneHit floor = caster.first({low, {0, 0, -1}});
        ASSERT_TRUE(floor.body) << level << " " << index;
        EXPECT_NEAR(floor.hit.t, 0.01, 1e-9) << "the floor is the plane z = 0";
      }
      double lowest = 0;
      for (const Body& body : walls) lowest = std::min(lowest, body.T_world_body.translation().z());
      const Body table = withLabel(scene, 1).front();
      EXPECT_NEAR((table.T_world_body * bounds(table.shape).max()).z(), lowest, 1e-9) << "it stands on the table";
    }
  }
}

TEST(EverydayLevels, TotesAreSeenFromAboveAndShelvesFromTheFront) {
  double steepest_deg = 0;
  for (int index = 0; index < kScenes; ++index) {
    const auto tilt = [&](const char* level) {
      return std::asin(-generate(request(level, index)).T_world_camera.linear()(2, 2)) / kDegree;
    };
    EXPECT_GT(tilt("tote"), 65 - 1e-6);
    EXPECT_LT(tilt("shelf"), 40 + 1e-6);
    steepest_deg = std::max(steepest_deg, tilt("tote"));
  }
  EXPECT_GT(steepest_deg, 85) << "from straight above, nearly";
}

TEST(EverydayLevels, StacksAreFlush) {
  int exact = 0, near = 0;
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request("stacks", index));
    int pairs = 0;
    for (const SceneObject& upper : scene.objects) {
      for (const SceneObject& lower : scene.objects) {
        if (std::abs(baseOf(upper) - topOf(lower)) > 1e-9) continue;
        const double aside = (placeOf(upper) - placeOf(lower)).norm();
        if (aside > 0.02) continue;
        EXPECT_LE(aside, 0.003 * std::sqrt(2) + 1e-12);
        EXPECT_EQ(upper.kind, lower.kind);
        EXPECT_TRUE(upper.size_m.isApprox(lower.size_m, 1e-12));
        EXPECT_TRUE(upper.T_world_box.linear().isApprox(lower.T_world_box.linear(), 1e-9));
        (aside < 1e-9 ? exact : near) += 1;
        ++pairs;
      }
      EXPECT_LE(topOf(upper), 0.45 + 1e-9);
    }
    EXPECT_GE(pairs, 1) << "scene " << index;
  }
  EXPECT_GT(exact, kScenes / 4);
  EXPECT_GT(near, kScenes / 4);
}

TEST(EverydayLevels, SomethingIsInABowlOrOnAPlate) {
  std::map<std::string, int> within;
  for (int index = 0; index < kScenes; ++index) {
    const Scene scene = generate(request("contents", index));
    int here = 0;
    for (const SceneObject& thing : scene.objects) {
      for (const SceneObject& holder : scene.objects) {
        if (holder.kind != "bowl" && holder.kind != "plate" && holder.kind != "pan") continue;
        if (baseOf(thing) < 1e-4 || baseOf(thing) > topOf(holder)) continue;
        const Vector2d aside = (holder.T_world_box.inverse() * thing.T_world_box.translation()).head<2>();
        if ((aside.array().abs() > holder.size_m.head<2>().array() / 2).any()) continue;
        ++within[holder.kind];
        ++here;
      }
    }
    EXPECT_GE(here, 1) << "scene " << index;
  }
  EXPECT_EQ(within.size(), 3u) << "bowls, plates and pans";
}

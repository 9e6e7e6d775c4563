// SPDX-License-Identifier: BSD-3-Clause
// The table is what things stand on, with the floor it stands on, its legs, a robot's arm and racks in view, too.
#include <gtest/gtest.h>

#include "fixtures/generated_scene.hpp"
#include "objectness_segmentation/scene/table.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// How far the plane that was found lies from the true one at the foot of the camera, metres; 1 when it is another one.
double errorOf(const std::string& level, std::uint32_t index) {
  const sim::SceneRequest wanted = request(level, index);
  const sim::Scene scene = generate(wanted);
  sim::DepthSensor sensor;
  sensor.camera = wanted.camera;
  const sim::SimulatedFrame seen =
      simulateFrame(scene, scene.T_world_camera, sensor, sim::noiseSeed(wanted.seed, index, 0));
  const Result<Frame> frame = makeFrame(seen.images.depth_mm, seen.images.color, seen.images.camera, {});
  EXPECT_TRUE(frame.ok()) << frame.status.message;
  const Result<Table> table = findTable(frame.value, estimateNormals(frame.value, {}), {});
  if (!table.ok() || table.value.normal.dot(seen.table_normal) < 0.998) return 1;
  return std::abs(table.value.d - seen.table_distance_m);
}

}  // namespace

TEST(TableOverAFloor, IsFoundWithLowThingsAlone) {
  EXPECT_LT(errorOf("plates", 3), 0.01) << "a rack and the table's leg stand on the floor, cutlery on the table";
  EXPECT_LT(errorOf("plates", 4), 0.01);
}

TEST(TableOverAFloor, IsFoundBesideAnArmThatComesFromOutOfThePicture) { EXPECT_LT(errorOf("tray", 5), 0.01); }

TEST(TableOverAFloor, IsFoundInNearlyAllEverydayScenes) {
  int found = 0, scenes = 0;
  for (const char* level : {"plates", "tray", "stacks", "contents"}) {
    for (std::uint32_t index = 6; index < 10; ++index) {
      ++scenes;
      found += errorOf(level, index) < 0.015;  // a tray's floor and the table are both right
    }
  }
  EXPECT_GE(found, scenes - 1);
}

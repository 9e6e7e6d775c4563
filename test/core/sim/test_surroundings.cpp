// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "common/angles.hpp"
#include "common/true_labels.hpp"
#include "fixtures/generated_scene.hpp"
#include "sim/lenses.hpp"

using namespace objectness;
using namespace objectness::sim;
using namespace objectness_test;

namespace {

constexpr int kScenes = 40;  // of each level

class SurroundedLevel : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(SurroundedLevel, HasAroundItWhatWasAskedForAndThatIsNoObject) {
  std::set<std::string> drawn;
  for (int index = 0; index < kScenes; ++index) {
    for (const SceneBackground& background : generate(request(GetParam(), index)).background) {
      drawn.insert(background.kind);
    }
  }
  const StageKind stage = findLevel(GetParam())->stage;
  std::set<std::string> all{"arm", "wall", "rack", "table"};
  if (stage != StageKind::kTable) all.insert(toString(stage));
  EXPECT_EQ(drawn, all);
  for (const char* name : {"none", "arm", "wall", "rack", "table", "arm,wall,rack,table"}) {
    SceneRequest asked = request(GetParam(), 0);
    asked.around = parseSurroundings(name).value;
    const Scene scene = generate(asked);
    std::string listed;
    for (const SceneBackground& background : scene.background) {
      if (background.label != kAroundLabel) continue;
      listed += (listed.empty() ? "" : ",") + background.kind;
    }
    EXPECT_EQ(listed.empty() ? "none" : listed, name);
    EXPECT_EQ(withLabel(scene, kAroundLabel).empty(), listed.empty());
    std::set<int> objects;
    for (const Body& body : scene.bodies) {
      if (body.label > kAroundLabel) objects.insert(body.label);
    }
    EXPECT_EQ(objects.size(), scene.objects.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, SurroundedLevel,
                         testing::ValuesIn(levelsThat([](const Level& level) { return level.everyday; })),
                         [](const auto& info) { return info.param; });

TEST(Surroundings, OlderLevelsHaveNothingAroundUnlessAskedTo) {
  for (const Level& level : levels()) {
    if (level.everyday) continue;
    EXPECT_TRUE(generate(request(level.name, 0)).background.empty()) << level.name;
    EXPECT_EQ(level.view.min_tilt_deg, kMinTilt_deg);
    EXPECT_EQ(level.view.max_tilt_deg, kMaxTilt_deg);
    SceneRequest asked = request(level.name, 0);
    asked.around = Surroundings{true, true, true, true};
    EXPECT_EQ(generate(asked).background.size(), 4u) << level.name;
  }
}

TEST(Surroundings, AreReadFromText) {
  const Result<Surroundings> some = parseSurroundings("rack,arm");
  ASSERT_TRUE(some.ok());
  EXPECT_TRUE(some.value.rack && some.value.arm && !some.value.wall && !some.value.table);
  EXPECT_FALSE(parseSurroundings("none").value.arm);
  for (const char* wrong : {"", "leg", "arm,", "arm,none", "arm;rack"}) {
    EXPECT_FALSE(parseSurroundings(wrong).ok()) << wrong;
  }
}

TEST(Lenses, AreOfRealCamerasFromSmallToLarge) {
  EXPECT_EQ(lenses().front().camera.width, 320);
  EXPECT_EQ(lenses().back().camera.height, 1080);
  EXPECT_EQ(findLens("fisheye"), nullptr);
  int width = 0;
  for (const Lens& lens : lenses()) {
    EXPECT_TRUE(validate(lens.camera).ok()) << lens.name;
    EXPECT_GE(lens.camera.width, width);
    width = lens.camera.width;
    const double view_deg = 2 * std::atan(lens.camera.width / (2 * lens.camera.fx)) / kDegree;
    EXPECT_GT(view_deg, 50) << lens.name;
    EXPECT_LT(view_deg, 95) << lens.name;
    EXPECT_NE(lensNames().find(lens.name), std::string::npos);
  }
}

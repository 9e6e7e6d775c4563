// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/scenes.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness::evaluation;
using namespace objectness_test;

namespace {

class Scenes : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* scene : {"kitchen/b", "kitchen/a", "kitchen/bare"}) writeBytes(folder_ / scene + "/depth.png", "");
    for (const char* scene : {"kitchen/b", "kitchen/a"}) writeBytes(folder_ / scene + "/labels.png", "");
    writeBytes(folder_ / "kitchen/notes/readme.txt", "no scene");
  }
  SceneList find(const std::string& path, const std::string& groups = "") const {
    const auto list = findScenes({path}, groups);
    EXPECT_TRUE(list.ok()) << list.status.message;
    return list.value;
  }

  TemporaryFolder folder_;
};

}  // namespace

TEST_F(Scenes, OfADataSetInTheOrderOfTheirNames) {
  const SceneList list = find(folder_ / "kitchen/");
  ASSERT_EQ(list.scenes.size(), 2u);
  EXPECT_EQ(list.scenes[0].name, "a");
  EXPECT_EQ(list.scenes[1].name, "b");
  EXPECT_EQ(list.scenes[1].folder, folder_ / "kitchen/b");
  EXPECT_EQ(list.scenes[0].group, "all");
  ASSERT_EQ(list.notes.size(), 1u);
  EXPECT_NE(list.notes[0].find("labels.png: bare"), std::string::npos) << list.notes[0];
  EXPECT_TRUE(list.errors.empty());
}

TEST_F(Scenes, GroupsFromTheFileGivenInsideAndBeside) {
  writeBytes(folder_ / "kitchen_groups.csv", "group,scene\r\nbeside,a\r\n");
  EXPECT_EQ(find(folder_ / "kitchen").scenes[0].group, "beside");
  EXPECT_EQ(find(folder_ / "kitchen/a/").scenes[0].group, "beside");
  writeBytes(folder_ / "kitchen/groups.csv", "scene,group\na,inside\n");
  EXPECT_EQ(find(folder_ / "kitchen").scenes[0].group, "inside");
  EXPECT_EQ(find(folder_ / "kitchen").scenes[1].group, "all");
  writeBytes(folder_ / "mine.csv", "scene,weight,group\nb,3,given\n");
  EXPECT_EQ(find(folder_ / "kitchen", folder_ / "mine.csv").scenes[1].group, "given");
  EXPECT_EQ(find(folder_ / "kitchen", folder_ / "mine.csv").scenes[0].group, "all");
}

TEST_F(Scenes, ThatCannotBeUsed) {
  EXPECT_NE(find(folder_ / "kitchen/bare").errors.at(0).find("holds no labels.png"), std::string::npos);
  EXPECT_NE(find(folder_ / "kitchen/notes").errors.at(0).find("neither is a scene folder nor holds any"),
            std::string::npos);
  EXPECT_NE(find(folder_ / "missing").errors.at(0).find("there is no such folder"), std::string::npos);
  EXPECT_NE(find(folder_ / "kitchen/a/depth.png").errors.at(0).find("is no folder"), std::string::npos);
  writeBytes(folder_ / "garden/a/labels.png", "");
  const auto twice = findScenes({folder_ / "kitchen", folder_ / "garden", folder_ / "kitchen/a"}, "");
  EXPECT_EQ(twice.value.scenes.size(), 2u);
  ASSERT_EQ(twice.value.errors.size(), 1u);  // the scene given twice is no problem
  EXPECT_NE(twice.value.errors[0].find("has the same name as " + (folder_ / "kitchen/a")), std::string::npos);
}

TEST_F(Scenes, GroupFilesThatCannotBeUsed) {
  EXPECT_NE(findScenes({}, folder_ / "none.csv").status.message.find("there is no such file"), std::string::npos);
  writeBytes(folder_ / "bad.csv", "a,b\n");
  EXPECT_NE(findScenes({}, folder_ / "bad.csv").status.message.find("must name the columns scene and group"),
            std::string::npos);
}

TEST_F(Scenes, WithBoxesAloneWhereBoxesAreTruth) {
  writeBytes(folder_ / "kitchen/c/depth.png", "");
  writeBytes(folder_ / "kitchen/c/objects.yaml", "");
  EXPECT_EQ(find(folder_ / "kitchen").scenes.size(), 2u);
  const SceneList list = findScenes({folder_ / "kitchen"}, "", {true, false}).value;
  ASSERT_EQ(list.scenes.size(), 3u);
  EXPECT_EQ(list.scenes[2].name, "c");
  EXPECT_EQ(list.scenes[2].camera, "kitchen");
  ASSERT_EQ(list.notes.size(), 1u);
  EXPECT_NE(list.notes[0].find("no labels.png and no objects.yaml: bare"), std::string::npos) << list.notes[0];
  EXPECT_EQ(findScenes({folder_ / "kitchen/c"}, "", {true, false}).value.scenes.size(), 1u);
  EXPECT_NE(findScenes({folder_ / "kitchen/bare"}, "", {true, false}).value.errors.at(0).find("and no objects.yaml"),
            std::string::npos);
}

TEST_F(Scenes, OfOneNameAreToldApartByTheirDataSets) {
  writeBytes(folder_ / "garden/a/labels.png", "");
  writeBytes(folder_ / "other/garden/a/labels.png", "");
  const SceneRules rules{false, true};
  const SceneList list = findScenes({folder_ / "kitchen", folder_ / "garden", folder_ / "kitchen/a/"}, "", rules).value;
  ASSERT_EQ(list.scenes.size(), 3u);
  EXPECT_TRUE(list.errors.empty());
  EXPECT_EQ(list.scenes[0].name, "kitchen/a");
  EXPECT_EQ(list.scenes[1].name, "b") << "where nothing is to be told apart names stay";
  EXPECT_EQ(list.scenes[2].name, "garden/a");
  EXPECT_EQ(list.scenes[2].camera, "garden");
  const SceneList same = findScenes({folder_ / "garden", folder_ / "other/garden"}, "", rules).value;
  EXPECT_EQ(same.scenes.size(), 1u);
  ASSERT_EQ(same.errors.size(), 1u);
  EXPECT_NE(same.errors[0].find("has the same name as"), std::string::npos);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "fixtures/temporary_folder.hpp"
#include "grouping/group_cues.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"

using namespace objectness;
using namespace objectness_test;
using Json = nlohmann::json;

namespace {

template <class Cues>
Forest constant(float value) {
  return {cueNames<Cues>(), {{{-1, 0, 0, 0, value}}}};
}

Json smallModel() {
  return Json::parse(
      toJson({constant<ContactCues>(0.25f), constant<GapCues>(0.5f), constant<GroupCues>(0.75f), "three leaves"}));
}

void expectRefused(const std::string& text, const std::string& error) {
  const Result<LearnedObjectness> read = parseModel(text);
  EXPECT_EQ(read.status.code, StatusCode::kBadInput) << text.substr(0, 60);
  EXPECT_NE(read.status.message.find(error), std::string::npos) << read.status.message;
}

template <class Cues>
void expectNamedColumns() {
  const std::vector<std::string> names = cueNames<Cues>();
  EXPECT_EQ(cueValues(Cues()).size(), names.size());
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "a name twice";
  EXPECT_EQ(sizeof(Cues), names.size() * sizeof(float)) << "a cue that is not listed";
}

}  // namespace

TEST(LearnedObjectness, EveryCueIsAColumn) {
  expectNamedColumns<ContactCues>();
  expectNamedColumns<GapCues>();
  expectNamedColumns<GroupCues>();
}

TEST(LearnedObjectness, TheDefaultModelIsOfThisVersionsCues) {
  const LearnedObjectness& model = defaultModel();
  EXPECT_EQ(model.contact.cues, cueNames<ContactCues>());
  EXPECT_EQ(model.gap.cues, cueNames<GapCues>());
  EXPECT_EQ(model.group.cues, cueNames<GroupCues>());
  for (const Forest* forest : {&model.contact, &model.gap, &model.group}) {
    for (const auto& tree : forest->trees) {
      for (const Forest::Node& node : tree) {
        if (node.cue >= 0) continue;
        EXPECT_GE(node.value, 0);
        EXPECT_LE(node.value, 1);
      }
    }
  }
}

TEST(LearnedObjectness, TheDefaultModelIsTheFileInCfg) {
  const Result<LearnedObjectness> file = loadModel(REPOSITORY_DIR "/cfg/objectness_model.json");
  ASSERT_TRUE(file.ok()) << file.status.message;
  const LearnedObjectness& built_in = defaultModel();
  EXPECT_EQ(built_in.trained_on, file.value.trained_on);
  for (const auto part : {&LearnedObjectness::contact, &LearnedObjectness::gap, &LearnedObjectness::group}) {
    const auto &own = (built_in.*part).trees, &expected = (file.value.*part).trees;
    ASSERT_EQ(own.size(), expected.size());
    for (std::size_t t = 0; t < own.size(); ++t) {
      ASSERT_EQ(own[t].size(), expected[t].size());
      for (std::size_t i = 0; i < own[t].size(); ++i) {
        const Forest::Node &a = own[t][i], &b = expected[t][i];
        EXPECT_EQ(std::tie(a.cue, a.threshold, a.left, a.right, a.value),
                  std::tie(b.cue, b.threshold, b.left, b.right, b.value));
      }
    }
  }
}

TEST(LearnedObjectness, ComesBackFromAFile) {
  const TemporaryFolder folder;
  writeBytes(folder / "model.json", smallModel().dump());
  const Result<LearnedObjectness> read = loadModel(folder / "model.json");
  ASSERT_TRUE(read.ok()) << read.status.message;
  EXPECT_EQ(read.value.contact.predict(cueValues(ContactCues())), 0.25f);
  EXPECT_EQ(read.value.gap.predict(cueValues(GapCues())), 0.5f);
  EXPECT_EQ(read.value.group.predict(cueValues(GroupCues())), 0.75f);
  EXPECT_EQ(read.value.trained_on, "three leaves");
  EXPECT_EQ(loadModel(folder / "none.json").status.code, StatusCode::kBadInput);
}

TEST(LearnedObjectness, MissingAndWrongPartsAreNamed) {
  for (const char* part : {"contact", "gap", "group"}) {
    Json model = smallModel();
    model.erase(part);
    expectRefused(model.dump(), "has no \"" + std::string(part) + "\"");
    model = smallModel();
    model[part]["trees"] = Json::array();
    expectRefused(model.dump(), "\"" + std::string(part) + "\" has no tree");
    model = smallModel();
    model[part]["cues"].push_back("smell");
    expectRefused(model.dump(), "\"" + std::string(part) + "\" is made for the cues");
    expectRefused(model.dump(), "smell");
    model = smallModel();
    model[part] = 3;
    expectRefused(model.dump(), "\"" + std::string(part) + "\" is no forest");
  }
}

TEST(LearnedObjectness, WhatIsNoModelIsRefused) {
  for (const char* text : {"", "[]", "3", "{\"contact\":", "null"}) expectRefused(text, "not a JSON object");
  Json model = smallModel();
  model["trained_on"] = 5;
  expectRefused(model.dump(), "trained_on");
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "learning/forest_trainer.hpp"
#include "objectness_segmentation/learning/forest.hpp"

using namespace objectness;
using Json = nlohmann::json;

namespace {

const std::vector<std::string> kCues = {"a", "b"};

/// a <= 0.5 ? (b <= -1 ? 1 : 2) : 4, and a second tree that says 10 everywhere.
Forest handMade() {
  return {kCues,
          {{{0, 0.5f, 1, 2, 0}, {1, -1.f, 3, 4, 0}, {-1, 0, 0, 0, 4}, {-1, 0, 0, 0, 1}, {-1, 0, 0, 0, 2}},
           {{-1, 0, 0, 0, 10}}}};
}

/// 1 where a > 0.3, else 0; b is noise.
Samples step(int count) {
  Samples samples;
  samples.cues = kCues;
  std::mt19937 random(2);
  for (int i = 0; i < count; ++i) {
    const float a = random() / 4294967296.f, b = random() / 4294967296.f;
    samples.add({a, b}, a > 0.3f ? 1.f : 0.f);
  }
  return samples;
}

}  // namespace

TEST(Forest, PredictsTheMeanOfItsTrees) {
  const struct {
    float a, b, tree;
  } cases[] = {{0, -2, 1}, {0, -1, 1}, {0, 0, 2}, {0.5f, 0, 2}, {0.51f, -2, 4}, {7, 7, 4}};
  for (const auto& c : cases) EXPECT_FLOAT_EQ(handMade().predict({c.a, c.b}), (c.tree + 10) / 2) << c.a << " " << c.b;
  EXPECT_EQ(Forest().predict({1, 2}), 0);
}

TEST(Forest, ComesBackFromJson) {
  const Json json = toJson(handMade());
  const Result<Forest> read = parseForest(json, kCues);
  ASSERT_TRUE(read.ok()) << read.status.message;
  EXPECT_EQ(toJson(read.value), json);
  for (const std::vector<float>& values : {std::vector<float>{0, -2}, {0, 0}, {1, 0}}) {
    EXPECT_FLOAT_EQ(read.value.predict(values), handMade().predict(values));
  }
}

TEST(Forest, JsonKeepsFiveDigits) {
  const Forest forest{kCues, {{{0, 0.123456789f, 1, 2, 0}, {-1, 0, 0, 0, 1.f / 3}, {-1, 0, 0, 0, -2e-7f / 3}}}};
  const Result<Forest> read = parseForest(Json::parse(toJson(forest).dump()), kCues);
  ASSERT_TRUE(read.ok()) << read.status.message;
  EXPECT_FLOAT_EQ(read.value.trees[0][0].threshold, 0.12346f);
  EXPECT_FLOAT_EQ(read.value.trees[0][1].value, 0.33333f);
  EXPECT_FLOAT_EQ(read.value.trees[0][2].value, -6.6667e-8f);
}

TEST(Forest, MalformedJsonIsRefusedWithItsReason) {
  const char* const no_reference = "tree 0 refers to nodes or cues that do not exist";
  const struct {
    const char *what, *json, *error;
  } cases[] = {
      {"a node that leads to itself", R"({"cues":["a","b"],"trees":[[[0,1,0,1],[1]]]})", no_reference},
      {"a way back", R"({"cues":["a","b"],"trees":[[[0,1,1,2],[0,1,0,2],[1]]]})", no_reference},
      {"no such node", R"({"cues":["a","b"],"trees":[[[0,1,1,7],[1]]]})", no_reference},
      {"a negative node", R"({"cues":["a","b"],"trees":[[[0,1,-1,1],[1]]]})", no_reference},
      {"no such cue", R"({"cues":["a","b"],"trees":[[[2,1,1,2],[1],[1]]]})", no_reference},
      {"a negative cue", R"({"cues":["a","b"],"trees":[[[-3,1,1,2],[1],[1]]]})", no_reference},
      {"no node", R"({"cues":["a","b"],"trees":[[]]})", no_reference},
      {"the second tree", R"({"cues":["a","b"],"trees":[[[1]],[]]})", "tree 1 refers"},
      {"other cues", R"({"cues":["b","a"],"trees":[[[1]]]})", "is made for the cues b, a, this version has a, b"},
      {"fewer cues", R"({"cues":["a"],"trees":[[[1]]]})", "is made for the cues a, this version has a, b"},
      {"no tree", R"({"cues":["a","b"],"trees":[]})", "has no tree"},
      {"no trees", R"({"cues":["a","b"]})", "is no forest: "},
      {"no cues", R"({"trees":[[[1]]]})", "is no forest: "},
      {"half a node", R"({"cues":["a","b"],"trees":[[[0,1,1]]]})", "is no forest: "},
      {"an empty node", R"({"cues":["a","b"],"trees":[[[]]]})", "is no forest: "},
      {"text for a number", R"({"cues":["a","b"],"trees":[[["x"]]]})", "is no forest: "},
      {"null for a number", R"({"cues":["a","b"],"trees":[[[null]]]})", "is no forest: "},
      {"a number for a node", R"({"cues":["a","b"],"trees":[[3]]})", "is no forest: "},
      {"a list", R"([1, 2])", "is no forest: "},
  };
  for (const auto& c : cases) {
    const Result<Forest> read = parseForest(Json::parse(c.json), kCues);
    EXPECT_EQ(read.status.code, StatusCode::kBadInput) << c.what;
    EXPECT_NE(read.status.message.find(c.error), std::string::npos) << c.what << ": " << read.status.message;
  }
}

TEST(ForestTrainer, LearnsAStep) {
  const Forest forest = trainForest(step(600), {});
  EXPECT_EQ(forest.cues, kCues);
  EXPECT_EQ(static_cast<int>(forest.trees.size()), ForestSettings().trees);
  for (const float b : {0.1f, 0.5f, 0.9f}) {
    EXPECT_LT(forest.predict({0.05f, b}), 0.05f);
    EXPECT_LT(forest.predict({0.2f, b}), 0.2f);
    EXPECT_GT(forest.predict({0.4f, b}), 0.8f);
    EXPECT_GT(forest.predict({0.95f, b}), 0.95f);
  }
  EXPECT_TRUE(parseForest(toJson(forest), kCues).ok()) << "children come after their parents";
}

TEST(ForestTrainer, DependsOnSamplesAndSeedOnly) {
  const Samples samples = step(200);
  const Json first = toJson(trainForest(samples, {}));
  trainForest(step(150), {});
  EXPECT_EQ(toJson(trainForest(samples, {})), first);
  ForestSettings other;
  other.seed = 2;
  EXPECT_NE(toJson(trainForest(samples, other)), first);
}

TEST(ForestTrainer, KeepsToItsSettings) {
  ForestSettings settings;
  settings.trees = 3;
  settings.depth = 2;
  const Forest forest = trainForest(step(300), settings);
  ASSERT_EQ(forest.trees.size(), 3u);
  for (const auto& tree : forest.trees) EXPECT_LE(tree.size(), 7u);
  settings.min_samples = 1000;  // more than there are: nothing is split
  for (const auto& tree : trainForest(step(300), settings).trees) {
    ASSERT_EQ(tree.size(), 1u);
    EXPECT_NEAR(tree[0].value, 0.7f, 0.1f);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "evaluation/methods.hpp"
#include "fixtures/leaf_model.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"

using namespace objectness;
using namespace objectness::evaluation;

TEST(Methods, AreTheOnesAskedForOnceEach) {
  Config config;
  config.runtime.threads = 3;
  const auto methods = makeMethods({"lccp", "paper", "lccp"}, config);
  ASSERT_TRUE(methods.ok());
  ASSERT_EQ(methods.value.size(), 2u);
  EXPECT_EQ(methods.value[0].name, "lccp");
  EXPECT_EQ(methods.value[1].name, "paper");
  EXPECT_NE(methods.value[1].settings.find("threads: 3"), std::string::npos);
  EXPECT_NE(makeMethods({"graph"}, {}).status.message.find("there is no method 'graph'"), std::string::npos);
  EXPECT_EQ(methodNames().front(), "objectness");
}

TEST(Methods, BoxesAreThoseOfThePreset) {
  Config preset;
  ASSERT_TRUE(loadConfig(REPOSITORY_DIR "/cfg/plain_boxes.yaml", preset).ok());
  EXPECT_EQ(makeMethods({"boxes"}, {}).value.at(0).settings, toYaml(preset));
}

TEST(Methods, RunWithTheConfigurationButForWhatMakesThem) {
  Config config;
  config.pipeline.method = SegmentationMethod::kPaper;
  config.input.max_depth_m = 2.5;
  const auto methods = makeMethods({"objectness", "paper", "mps"}, config);
  ASSERT_TRUE(methods.ok());
  for (const Method& method : methods.value) {
    EXPECT_EQ(method.input.max_depth_m, 2.5) << method.name;
    EXPECT_NE(method.settings.find("max_depth_m: 2.5"), std::string::npos) << method.name;
  }
  config.pipeline.method = SegmentationMethod::kObjectness;
  EXPECT_EQ(methods.value[0].settings, toYaml(config));
}

TEST(Methods, SettingsTellModelsApart) {
  const auto model = [](float value) { return objectness_test::leafModel(0.5f, 0.5f, value); };
  std::set<std::string> settings = {makeMethods({"objectness"}, {}).value.at(0).settings};
  for (const float value : {0.25f, 0.5f})
    settings.insert(makeMethods({"objectness"}, {}, model(value)).value[0].settings);
  EXPECT_EQ(settings.size(), 3u);
  EXPECT_EQ(makeMethods({"paper"}, {}, model(0.5f)).value[0].settings, makeMethods({"paper"}, {}).value[0].settings)
      << "it has no use for one";
}

TEST(Methods, TheOracleAndClusteringAreRunWhenAskedFor) {
  const std::vector<std::string> all = methodNames(), usual = usualMethodNames();
  EXPECT_EQ(usual, std::vector<std::string>(all.begin(), all.end() - 2));
  EXPECT_EQ((std::vector<std::string>{"clustering", "oracle"}), std::vector<std::string>(all.end() - 2, all.end()));
  const auto methods = makeMethods({"oracle", "clustering"}, {});
  ASSERT_TRUE(methods.ok());
  EXPECT_TRUE(methods.value[0].run_knowing);
  EXPECT_FALSE(methods.value[1].run_knowing);
  const auto model = objectness_test::leafModel(0.5f, 0.5f, 0.5f);
  const auto learned = makeMethods({"oracle", "clustering"}, {}, model);
  EXPECT_EQ(learned.value[0].settings, methods.value[0].settings) << "it has no use for one";
  EXPECT_NE(learned.value[1].settings, methods.value[1].settings);
}

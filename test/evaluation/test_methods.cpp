// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "objectness_segmentation/evaluation/methods.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"

using namespace objectness;
using namespace objectness::evaluation;

TEST(Methods, AreTheOnesAskedForOnceEach) {
  const auto methods = makeMethods({"lccp", "paper", "lccp"}, 3);
  ASSERT_TRUE(methods.ok());
  ASSERT_EQ(methods.value.size(), 2u);
  EXPECT_EQ(methods.value[0].name, "lccp");
  EXPECT_EQ(methods.value[1].name, "paper");
  EXPECT_NE(methods.value[1].settings.find("threads: 3"), std::string::npos);
  EXPECT_NE(makeMethods({"graph"}, 1).status.message.find("there is no method 'graph'"), std::string::npos);
  EXPECT_EQ(methodNames().front(), "objectness");
}

TEST(Methods, BoxesAreThoseOfThePreset) {
  Config preset;
  ASSERT_TRUE(loadConfig(REPOSITORY_DIR "/cfg/plain_boxes.yaml", preset).ok());
  EXPECT_EQ(makeMethods({"boxes"}, preset.runtime.threads).value.at(0).settings, toYaml(preset));
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/learn.hpp"

using namespace objectness;
using namespace objectness::evaluation;

TEST(Learn, NeedsTwoFoldsAndAsManyScenes) {
  const std::vector<Scene> scenes(3);
  LearnSettings settings;
  for (const int folds : {-1, 0, 1}) {
    settings.folds = folds;
    const Result<LearnedModel> learned = learn(scenes, settings);
    EXPECT_EQ(learned.status.code, StatusCode::kBadInput);
    EXPECT_EQ(learned.status.message, std::to_string(folds) + " folds: there must be at least 2");
  }
  settings.folds = 4;
  EXPECT_EQ(learn(scenes, settings).status.message, "3 scenes are too few for 4 folds");
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "ros/throttled_problems.hpp"

namespace {

using objectness_segmentation::ThrottledProblems;
using std::chrono::seconds;

TEST(ThrottledProblems, AKindIsSaidOnceInTenSeconds) {
  ThrottledProblems problems;
  const auto start = ThrottledProblems::Clock::now();
  EXPECT_TRUE(problems.isDue("no table", start));
  EXPECT_TRUE(problems.isDue("no transform", start));
  EXPECT_FALSE(problems.isDue("no table", start + seconds(9)));
  EXPECT_TRUE(problems.isDue("no table", start + seconds(10)));
  EXPECT_FALSE(problems.isDue("no table", start + seconds(19)));
}

TEST(ThrottledProblems, TextsThatDifferInNumbersOnlyAreOneKind) {
  ThrottledProblems problems;
  const auto start = ThrottledProblems::Clock::now();
  EXPECT_TRUE(problems.isTextDue("remark", "rgb is 640 x 480", start));
  EXPECT_FALSE(problems.isTextDue("remark", "rgb is 320 x 240", start));
  EXPECT_TRUE(problems.isTextDue("remark", "rgb is missing", start));
  EXPECT_TRUE(problems.isTextDue("remark", "rgb is 320 x 240", start + seconds(10)));
}

TEST(ThrottledProblems, TextsThatAlwaysChangeDoNotFillTheLog) {
  ThrottledProblems problems;
  const auto start = ThrottledProblems::Clock::now();
  int said = 0;
  std::string text;
  for (int i = 0; i < 3000; ++i) {  // 10 Hz, for five minutes
    text += static_cast<char>('a' + i % 26);
    said += problems.isTextDue("remark", text, start + std::chrono::milliseconds(100 * i));
  }
  EXPECT_LE(said, 30 * ThrottledProblems::kMaxTexts);
  EXPECT_GE(said, 30);
  EXPECT_TRUE(problems.isTextDue("another group", text, start + seconds(300)));
}

}  // namespace

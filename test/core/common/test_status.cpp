// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "objectness_segmentation/common/status.hpp"

using objectness::StatusCode;

TEST(Status, EveryCodeHasItsOwnName) {
  std::set<std::string> names;
  const int last = static_cast<int>(StatusCode::kNoInput);
  for (int code = 0; code <= last; ++code) names.insert(objectness::toString(static_cast<StatusCode>(code)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last + 1));
  EXPECT_EQ(names.count("unknown"), 0u);
}

TEST(Status, ErrorKeepsItsReason) {
  const auto result = objectness::Result<int>::error(StatusCode::kNoTable, "no plane");
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(result.status.message, "no plane");
}

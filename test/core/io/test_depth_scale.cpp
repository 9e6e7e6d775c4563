// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "objectness_segmentation/io/depth_scale.hpp"

using namespace objectness;

TEST(DepthScale, IsSaidEitherWay) {
  for (const char* text : {"5000", "5000.0", "5e3", "1/5000", "0.0002", "2e-4"}) {
    const Result<double> unit = depthUnit(text);
    ASSERT_TRUE(unit.ok()) << unit.status.message;
    EXPECT_DOUBLE_EQ(unit.value, 0.0002) << text;
  }
  EXPECT_DOUBLE_EQ(depthUnit("256").value, 1.0 / 256);
  EXPECT_DOUBLE_EQ(depthUnit("1000").value, 0.001);
  EXPECT_TRUE(depthUnit("1e6").ok());
  EXPECT_TRUE(depthUnit("0.02").ok());
}

TEST(DepthScale, RefusesWhatIsNoUnitOfDepth) {
  for (const char* text : {"", "mm", "1", "0", "-5000", "nan", "inf", "0.1", "10", "1e9", "1/0", "5000 mm", "1/"}) {
    const Result<double> unit = depthUnit(text);
    EXPECT_EQ(unit.status.code, StatusCode::kBadInput) << text;
    EXPECT_NE(unit.status.message.find(std::string("'") + text + "'"), std::string::npos) << unit.status.message;
  }
}

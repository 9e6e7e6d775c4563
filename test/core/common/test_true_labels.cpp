// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "common/true_labels.hpp"

using objectness::trueLabel;
using objectness::trueObject;

TEST(TrueLabels, ObjectsAreTheTensFromTwenty) {
  for (const int label : {0, 1, 9, 19}) EXPECT_EQ(trueObject(label), -1) << label;
  for (const int label : {20, 21, 29}) EXPECT_EQ(trueObject(label), 0) << label;
  EXPECT_EQ(trueObject(30), 1);
  EXPECT_EQ(trueObject(65535), 6551);
  for (int object = 0; object < 100; ++object) {
    EXPECT_EQ(trueObject(trueLabel(object)), object);
    EXPECT_EQ(trueObject(trueLabel(object) - 1), object - 1);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

#include "objectness_segmentation/common/parallel.hpp"

using objectness::parallelFor;

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(100, 0);
    parallelFor(100, threads, [&](int i) { ++calls[i]; });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 100);
    EXPECT_EQ(*std::max_element(calls.begin(), calls.end()), 1);
  }
  parallelFor(0, 2, [](int) { FAIL(); });
}

TEST(ParallelFor, RethrowsAndJoins) {
  std::atomic<int> calls{0};
  EXPECT_THROW(parallelFor(50, 2,
                           [&](int i) {
                             ++calls;
                             if (i == 3) throw std::runtime_error("stop");
                           }),
               std::runtime_error);
  EXPECT_GE(calls, 4);
}

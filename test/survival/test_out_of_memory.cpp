// SPDX-License-Identifier: BSD-3-Clause
// A program of its own, as it replaces operator new: whichever allocation of a frame fails, the core says so in its
// status, and segments the next frame as ever.
#include <gtest/gtest.h>

#include <random>

#include "failing_memory.hpp"
#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "small_frames.hpp"

namespace {

using namespace objectness_test;

class OutOfMemory : public ::testing::TestWithParam<objectness::SegmentationMethod> {};

TEST_P(OutOfMemory, AnyAllocationOfAFrameMayFail) {
  objectness::Config config;
  config.runtime.threads = 1;
  config.pipeline.method = GetParam();
  config.search.angle_step_deg = 45;
  const objectness::Frame frame = tableScene(2).render();
  const objectness::Segmentation good = objectness::segment(frame, config);
  ASSERT_TRUE(good.status.ok()) << good.status.message;

  std::mt19937 random(4);
  int failed = 0, last = 0;
  // The first hundred, then ever sparser ones to the last.
  for (int passes = 0;; passes += 1 + passes / 100 + (passes > 100 ? static_cast<int>(random() % (passes / 20)) : 0)) {
    FailingMemory::arm(passes % 2 == 0 ? Failure::kBadAlloc : Failure::kException, 0, passes, false);
    const objectness::Segmentation result = objectness::segment(frame, config);
    FailingMemory::disarm();
    if (!FailingMemory::fired()) break;
    ++failed;
    last = passes;
    // What is caught on the way (a thread that cannot be started) does no harm.
    if (result.status.ok()) {
      EXPECT_EQ(cv::countNonZero(result.labels != good.labels), 0) << passes;
      continue;
    }
    ASSERT_EQ(result.status.code, objectness::StatusCode::kInternalError) << passes << " " << result.status.message;
    EXPECT_EQ(result.status.message, passes % 2 == 0 ? "out of memory" : "injected") << passes;
  }
  std::printf("%d of %d allocations failed in turn\n", failed, last);
  EXPECT_GT(failed, 100);
  const objectness::Segmentation again = objectness::segment(frame, config);
  ASSERT_TRUE(again.status.ok()) << again.status.message;
  EXPECT_EQ(cv::countNonZero(again.labels != good.labels), 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, OutOfMemory,
                         ::testing::Values(objectness::SegmentationMethod::kObjectness,
                                           objectness::SegmentationMethod::kPaper),
                         [](const auto& method) {
                           return method.param == objectness::SegmentationMethod::kPaper ? "paper" : "default";
                         });

}  // namespace

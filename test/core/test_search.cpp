// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fixtures/random_volumes.hpp"
#include "objectness_segmentation/search/search.hpp"

using namespace objectness;
using objectness_test::randomVolumes;

namespace {

SearchTask smallTask() {
  SearchTask task;
  task.sampling = {1, 1, 1, 2, 9};
  task.ring = {1, 2};
  task.objectness.min_edge_voxels = 4;
  task.objectness.min_occupied_voxels = 6;
  task.threshold = 0.9;
  return task;
}

void expectSame(const SearchResult& fast, const SearchResult& plain) {
  ASSERT_EQ(fast.sampled, plain.sampled);
  ASSERT_LE(fast.scored, plain.scored);
  ASSERT_EQ(fast.boxes.size(), plain.boxes.size());
  for (std::size_t i = 0; i < plain.boxes.size(); ++i) {
    ASSERT_EQ(fast.boxes[i].box, plain.boxes[i].box);
    ASSERT_EQ(0, std::memcmp(&fast.boxes[i].objectness, &plain.boxes[i].objectness, sizeof(float)));
    ASSERT_EQ(0, std::memcmp(&fast.boxes[i].cues, &plain.boxes[i].cues, sizeof(CueValues)));
  }
}

}  // namespace

TEST(Sampler, PaperSamplingInVoxels) {
  const Sampling sampling = samplingOf(SearchConfig(), 0.01);
  EXPECT_EQ(sampling.corner_step, 2);
  EXPECT_EQ(sampling.size_step_xy, 2);
  EXPECT_EQ(sampling.size_step_z, 1);
  EXPECT_EQ(sampling.min_size, 3);
  EXPECT_EQ(sampling.max_size, 45);
}

TEST(Sampler, AnglesCoverAQuarterTurnWithoutItsEnd) {
  const std::vector<double> angles = sampledAngles(SearchConfig());
  ASSERT_EQ(angles.size(), 18u);
  EXPECT_EQ(angles.front(), 0);
  EXPECT_NEAR(angles.back(), 85 * M_PI / 180, 1e-12);
  SearchConfig sevenths;
  sevenths.angle_step_deg = 90.0 / 7;
  EXPECT_EQ(sampledAngles(sevenths).size(), 7u);
  SearchConfig one;
  one.angle_step_deg = 90;
  EXPECT_EQ(sampledAngles(one).size(), 1u);
}

TEST(Search, ScanEqualsThePlainLoopToTheLastBit) {
  std::size_t boxes = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SearchTask task = smallTask();
    objectness_test::Dice dice(seed + 1000);
    if (dice.below(2)) task.sampling = {2, 2, 1, 3, 45};
    if (dice.below(4) == 0) task.sampling = {2, 1, 2, 3, 7};
    task.objectness.three_face_area = dice.below(2);
    task.threshold = 0.5 + 0.6 * dice.unit();
    task.objectness.min_straddling = dice.unit();
    if (dice.below(4) == 0) {
      task.objectness.weight_outer = 2 * dice.unit() - 1;
      task.objectness.weight_free = 0.3 * (dice.unit() - 0.5);
      task.objectness.weight_edges = 2 * dice.unit() - 1;
    }
    const CueVolumes volumes = randomVolumes(seed, task.ring.z);
    const SearchResult plain = searchPlain(volumes, 5, task);
    ASSERT_EQ(plain.sampled, countBoxes(volumes.grid, task.sampling)) << "seed " << seed;
    boxes += plain.boxes.size();
    ASSERT_NO_FATAL_FAILURE(expectSame(searchScan(volumes, 5, task), plain)) << "seed " << seed;
  }
  EXPECT_GT(boxes, 5000u) << "the volumes must have boxes to find";
}

TEST(Search, ScanSkipsMostOfTheWork) {
  const SearchTask task = smallTask();
  std::int64_t sampled = 0, scored = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const SearchResult result = searchScan(randomVolumes(seed, task.ring.z), 0, task);
    sampled += result.sampled;
    scored += result.scored;
  }
  EXPECT_LT(scored, sampled / 4);
}

TEST(Search, ResultsComeInTheOrderOfEnumeration) {
  const SearchTask task = smallTask();
  const SearchResult result = searchScan(randomVolumes(1, task.ring.z), 3, task);
  ASSERT_FALSE(result.boxes.empty());
  for (std::size_t i = 1; i < result.boxes.size(); ++i) {
    EXPECT_LT(result.boxes[i - 1].box.key(), result.boxes[i].box.key());
  }
  for (const auto& scored : result.boxes) {
    EXPECT_EQ(scored.box.angle, 3);
    EXPECT_GE(scored.objectness, task.threshold);
  }
}

TEST(Search, AGridSmallerThanTheSmallestBoxHasNone) {
  SearchTask task = smallTask();
  task.sampling.min_size = 20;
  task.sampling.max_size = 45;
  const CueVolumes volumes = randomVolumes(1, task.ring.z);
  EXPECT_EQ(searchScan(volumes, 0, task).sampled, 0);
  EXPECT_TRUE(searchPlain(volumes, 0, task).boxes.empty());
}

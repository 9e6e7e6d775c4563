// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fixtures/random_volumes.hpp"
#include "reference/plain_search.hpp"
#include "search/bounded_search.hpp"
#include "search/ranking.hpp"
#include "search/scan_search.hpp"

using namespace objectness;
using objectness_test::Dice;
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

/// Any task that the bounds hold for.
SearchTask randomTask(Dice& dice) {
  SearchTask task = smallTask();
  if (dice.below(2)) task.sampling = {2, 2, 1, 3, 45};
  if (dice.below(4) == 0) task.sampling = {2, 1, 2, 3, 7};
  if (dice.below(6) == 0) task.sampling = {3, 2, 1, 1, 6};
  if (dice.below(4) == 0) task.ring = {dice.below(4), dice.below(3)};
  ObjectnessConfig& o = task.objectness;
  o.three_face_area = dice.below(2);
  task.threshold = 0.5 + 0.6 * dice.unit();
  o.min_straddling = dice.unit();
  if (dice.below(4) == 0) {
    o.weight_outer = dice.unit(), o.weight_edges = dice.unit(), o.weight_free = -0.3 * dice.unit();
    o.max_edge_density = 0.2 + dice.unit();
    o.min_straddling = dice.below(2) ? 0 : 0.3;
    o.constant = 0.5 - dice.unit();
    task.threshold = o.constant + 0.4 * dice.unit();
  }
  return task;
}

TEST(Search, BoundedAndScanEqualThePlainLoopToTheLastBit) {
  std::size_t boxes = 0;
  std::int64_t sampled = 0, nodes = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Dice dice(seed + 1000);
    const SearchTask task = randomTask(dice);
    const CueVolumes volumes = randomVolumes(seed, task.ring.z);
    const SearchResult plain = searchPlain(volumes, 5, task), bounded = searchBounded(volumes, 5, task);
    ASSERT_EQ(plain.sampled, countBoxes(volumes.grid, task.sampling)) << "seed " << seed;
    ASSERT_NO_FATAL_FAILURE(expectSame(bounded, plain)) << "seed " << seed;
    ASSERT_EQ(bounded.unbounded, "");
    if (seed % 4 == 0) {
      ASSERT_NO_FATAL_FAILURE(expectSame(searchScan(volumes, 5, task), plain)) << "seed " << seed;
    }
    boxes += plain.boxes.size();
    sampled += plain.sampled;
    nodes += bounded.nodes;
  }
  EXPECT_GT(boxes, 50000u) << "the volumes must have boxes to find";
  EXPECT_LT(nodes, sampled / 4) << "the bounds must rule something out";
}

TEST(Search, WeightsThatTheBoundsDoNotHoldForAreScannedAndSaidSo) {
  std::size_t boxes = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    SearchTask task = randomTask(dice);
    task.objectness.weight_outer = 2 * dice.unit() - 1;
    task.objectness.weight_edges = 2 * dice.unit() - 1;
    task.objectness.weight_free = 0.3 * dice.unit() + 1e-6;
    const CueVolumes volumes = randomVolumes(seed, task.ring.z);
    const SearchResult plain = searchPlain(volumes, 2, task), bounded = searchBounded(volumes, 2, task);
    ASSERT_NO_FATAL_FAILURE(expectSame(bounded, plain)) << "seed " << seed;
    EXPECT_NE(bounded.unbounded.find("weight_free"), std::string::npos) << bounded.unbounded;
    boxes += plain.boxes.size();
  }
  EXPECT_GT(boxes, 1000u);
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

TEST(Search, ResultsComeBestFirst) {
  const SearchTask task = smallTask();
  for (const auto search : {searchPlain, searchScan, searchBounded}) {
    const SearchResult result = search(randomVolumes(1, task.ring.z), 3, task);
    ASSERT_GT(result.boxes.size(), 10u);
    EXPECT_TRUE(std::is_sorted(result.boxes.begin(), result.boxes.end(), better));
    for (const auto& scored : result.boxes) {
      EXPECT_EQ(scored.box.angle, 3);
      EXPECT_GE(scored.objectness, task.threshold);
    }
  }
}

TEST(Search, SortingBestFirstIsTheOrderOfBetter) {
  Dice dice(4);
  std::vector<ScoredBox> boxes(500);
  for (auto& scored : boxes) {
    // Few values, so that many are equal; of either sign, and both zeros.
    scored.objectness = static_cast<float>(dice.between(-3, 3)) * (dice.below(2) ? 0.25f : -0.25f);
    scored.box = {dice.below(3), dice.below(9), 20, dice.below(9), 20, dice.below(9)};
  }
  std::vector<ScoredBox> expected = boxes;
  std::sort(expected.begin(), expected.end(), better);
  sortBestFirst(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(boxes[i].objectness, expected[i].objectness);
    EXPECT_EQ(boxes[i].box, expected[i].box);
  }
}

TEST(Search, MergedListsAreInTheOrderOfBetter) {
  for (const int size : {0, 7, 300, 4000}) {
    Dice dice(size);
    std::vector<std::vector<ScoredBox>> lists(18);
    std::vector<ScoredBox> expected;
    for (int angle = 0; angle < 18; ++angle) {
      lists[angle].resize(dice.below(3) == 0 ? 0 : dice.below(2 * size + 1));
      for (auto& scored : lists[angle]) {
        // Half of them have one value: more than a thread takes at once.
        scored.objectness = dice.below(2) ? 0.875f : static_cast<float>(dice.between(-1, 1));
        scored.box = {angle, dice.below(90), 95, dice.below(90), 95, dice.below(40)};
      }
      expected.insert(expected.end(), lists[angle].begin(), lists[angle].end());
      std::sort(lists[angle].begin(), lists[angle].end(), better);
    }
    std::sort(expected.begin(), expected.end(), better);
    for (const int threads : {1, 2, 5}) {
      const std::vector<ScoredBox> merged = mergeBestFirst(lists, threads);
      ASSERT_EQ(merged.size(), expected.size());
      for (std::size_t i = 0; i < merged.size(); ++i) {
        ASSERT_EQ(merged[i].objectness, expected[i].objectness) << size << " boxes a list, place " << i;
        ASSERT_EQ(merged[i].box, expected[i].box) << size << " boxes a list, place " << i;
      }
    }
  }
}

TEST(Search, AGridSmallerThanTheSmallestBoxHasNone) {
  SearchTask task = smallTask();
  task.sampling.min_size = 20;
  task.sampling.max_size = 45;
  const CueVolumes volumes = randomVolumes(1, task.ring.z);
  EXPECT_EQ(searchScan(volumes, 0, task).sampled, 0);
  EXPECT_EQ(searchBounded(volumes, 0, task).sampled, 0);
  EXPECT_TRUE(searchPlain(volumes, 0, task).boxes.empty());
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/cue_scene.hpp"
#include "fixtures/random_volumes.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "reference/plain_filter.hpp"
#include "search/angle_search.hpp"
#include "selection/hypotheses.hpp"
#include "selection/scene_points.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

BitProblem randomProblem(Dice& dice, int points, int count) {
  BitProblem problem;
  problem.layout = PointLayout(points);
  for (int i = 0; i < count; ++i) {
    BitHypothesis h;
    h.inside.words.assign(problem.layout.words(), 0);
    h.surroundings.words.assign(problem.layout.words(), 0);
    h.objectness = 0.8 + 0.6 * dice.unit();
    h.free_space = 40 * dice.unit();
    const int size = dice.between(1, points / 6), first = dice.below(points - size);
    for (int p = std::max(0, first - 20); p < std::min(points, first + size + 20); ++p) {
      if (dice.below(8) == 0) continue;
      (p >= first && p < first + size ? h.inside : h.surroundings).set(p, problem.layout);
    }
    problem.hypotheses.push_back(std::move(h));
  }
  return problem;
}

void expectPlainSelection(const BitProblem& problem, const SelectionConfig& config, unsigned seed) {
  const Selection fast = selectHypotheses(problem, config, seed);
  const Selection plain = selectHypotheses(listProblem(problem), config, seed);
  ASSERT_EQ(fast.active, plain.active);
  ASSERT_EQ(fast.cost, plain.cost);
}

/// The paper's boxes of a scene, filtered on bit sets and box by box.
void expectPlainHypotheses(const CueScene& scene, const FilterConfig& filter, Hypotheses& fast) {
  SearchSettings settings;
  settings.threshold = filter.threshold;
  const SearchOutcome found = searchAllAngles(scene.frame, scene.table, scene.points, settings, nullptr);
  const SelectionConfig selection;
  const auto points =
      thinPoints(scene.points.points, selection.point_spacing_m, found.grids.front().nz * found.grids.front().voxel_m);
  std::vector<PointOverlap> overlaps;
  for (const Grid& grid : found.grids) overlaps.emplace_back(points, grid, filter.box_margin_m);
  const std::vector<BoxHypothesis> plain = filterBoxes(found.boxes, found.grids, overlaps, filter);
  for (const int threads : {1, 2}) {
    fast = filterByObjectness(found.boxes, found.grids, scene.points.points, filter, selection, threads);
    ASSERT_EQ(fast.boxes.size(), plain.size());
    const int ring = 4;
    const CostProblem lists = listProblem(fast.problem);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const Box& box = plain[i].scored.box;
      ASSERT_EQ(fast.boxes[i].box, box);
      ASSERT_EQ(static_cast<int>(lists.hypotheses[i].inside.size()), countPoints(plain[i].points));
      const PointSet around = overlaps[box.angle].inside(box, ring, ring);
      ASSERT_EQ(static_cast<int>(lists.hypotheses[i].surroundings.size()),
                countPoints(around) - countShared(around, plain[i].points));
    }
  }
}

}  // namespace

TEST(PointLayout, GroupsCoverAllPointsInAtMost64) {
  for (const int points : {0, 1, 64, 65, 4096, 4097, 20000, 300000}) {
    const PointLayout layout(points);
    EXPECT_GE(layout.words() * 64, points);
    EXPECT_LE(layout.groups, 64);
    EXPECT_LE(layout.words() * 64, points + 64 * layout.group_words);
  }
}

TEST(BitSelection, SameMovesAsPointByPoint) {
  int chosen = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const BitProblem problem = randomProblem(dice, dice.between(60, 9000), dice.between(1, 60));
    SelectionConfig config;
    config.iterations = 400;
    if (dice.below(2)) config.start_temperature = 30;
    if (dice.below(3) == 0) config.weight_multiple = dice.unit(), config.weight_unexplained = dice.unit();
    ASSERT_NO_FATAL_FAILURE(expectPlainSelection(problem, config, seed)) << "seed " << seed;
    const Selection selection = selectHypotheses(problem, config, seed);
    EXPECT_NEAR(selection.cost, GlobalCost::evaluate(listProblem(problem), config, selection.active), 1e-6);
    for (const bool active : selection.active) chosen += active;
  }
  EXPECT_GT(chosen, 60);
}

TEST(BitSelection, NothingToChooseFrom) {
  const Selection selection = selectHypotheses(BitProblem(), SelectionConfig(), 1);
  EXPECT_TRUE(selection.active.empty());
  EXPECT_EQ(selection.cost, 0);
}

TEST(Suppression, KeepsTheBoxesOfThePlainFilter) {
  const CueScene scene = simulatedCueScene();
  Hypotheses hypotheses;
  FilterConfig filter;
  ASSERT_NO_FATAL_FAILURE(expectPlainHypotheses(scene, filter, hypotheses));
  EXPECT_GT(hypotheses.boxes.size(), 20u);
  ASSERT_NO_FATAL_FAILURE(expectPlainSelection(hypotheses.problem, SelectionConfig(), 1));
  filter.across_clusters = false;
  filter.cluster_radius_m = 0.02;
  filter.max_boxes_per_cluster = 20;
  filter.conflict_share = 0.8;
  ASSERT_NO_FATAL_FAILURE(expectPlainHypotheses(scene, filter, hypotheses));
  filter.cluster_radius_m = 0.001;
  filter.threshold = 0.95;
  ASSERT_NO_FATAL_FAILURE(expectPlainHypotheses(scene, filter, hypotheses));
}

TEST(Suppression, KeepsTheBoxesOfThePlainFilterOnARealScene) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  const auto read = loadSceneFolder(data + "/mosd/test43", std::nullopt, InputConfig());
  ASSERT_TRUE(read.ok()) << read.status.message;
  Hypotheses hypotheses;
  ASSERT_NO_FATAL_FAILURE(expectPlainHypotheses(cueScene(read.value), FilterConfig(), hypotheses));
  EXPECT_GT(hypotheses.boxes.size(), 100u);
  ASSERT_NO_FATAL_FAILURE(expectPlainSelection(hypotheses.problem, SelectionConfig(), 1));
}

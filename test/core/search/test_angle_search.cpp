// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "fixtures/cue_scene.hpp"
#include "fixtures/random_volumes.hpp"
#include "fixtures/temporary_folder.hpp"
#include "integral/cue_volumes.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "reference/plain_search.hpp"
#include "reference/plain_voxels.hpp"
#include "search/angle_search.hpp"
#include "search/ranking.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

void expectSameBoxes(const std::vector<ScoredBox>& a, const std::vector<ScoredBox>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].box, b[i].box) << "box " << i;
    ASSERT_EQ(0, std::memcmp(&a[i].objectness, &b[i].objectness, sizeof(float)));
    ASSERT_EQ(0, std::memcmp(&a[i].cues, &b[i].cues, sizeof(CueValues)));
  }
}

SearchSettings settingsOf(double threshold, int threads) {
  SearchSettings settings;
  settings.threshold = threshold;
  settings.threads = threads;
  return settings;
}

/// Every box of every `step`-th angle, scored one by one in volumes made voxel by voxel.
std::vector<ScoredBox> everyBox(const CueScene& scene, const SearchSettings& settings, int step) {
  const SearchTask task{samplingOf(settings.search, settings.volume.voxel_m),
                        ringOf(settings.objectness, settings.volume.voxel_m), settings.objectness, settings.threshold};
  const std::vector<double> angles = sampledAngles(settings.search);
  std::vector<ScoredBox> boxes;
  for (std::size_t angle = 0; angle < angles.size(); angle += step) {
    const Grid grid = makeGrid(scene.points, angles[angle], settings.volume, 3, 3, 45);
    CueVolumes volumes;
    integrate(markVoxelsPlain(scene.frame, scene.table, scene.points, grid, settings.volume), scene.table, task.ring.z,
              volumes);
    const SearchResult result = searchPlain(volumes, static_cast<int>(angle), task);
    boxes.insert(boxes.end(), result.boxes.begin(), result.boxes.end());
  }
  sortBestFirst(boxes);
  return boxes;
}

std::vector<ScoredBox> ofAngles(const std::vector<ScoredBox>& boxes, int step) {
  std::vector<ScoredBox> some;
  for (const ScoredBox& scored : boxes) {
    if (scored.box.angle % step == 0) some.push_back(scored);
  }
  return some;
}

void expectEveryBox(const CueScene& scene, SearchSettings settings, int step) {
  const std::vector<ScoredBox> plain = everyBox(scene, settings, step);
  EXPECT_FALSE(plain.empty());
  for (const int threads : {1, 2}) {
    settings.threads = threads;
    const SearchOutcome outcome = searchAllAngles(scene.frame, scene.table, scene.points, settings, nullptr);
    ASSERT_TRUE(outcome.status.ok()) << outcome.status.message;
    EXPECT_EQ(outcome.unbounded, "");
    ASSERT_NO_FATAL_FAILURE(expectSameBoxes(ofAngles(outcome.boxes, step), plain)) << threads << " threads";
  }
}

}  // namespace

TEST(AngleSearch, FindsEveryBoxOfThePlainLoopInASimulatedScene) {
  const CueScene scene = simulatedCueScene();
  expectEveryBox(scene, settingsOf(0.8, 1), 1);
  SearchSettings other = settingsOf(0.7, 1);
  other.objectness.weight_edges = 0.8, other.objectness.weight_outer = 0.3, other.objectness.weight_free = -0.02;
  expectEveryBox(scene, other, 3);
}

TEST(AngleSearch, TheTopKAreTheFirstOfAll) {
  const CueScene scene = simulatedCueScene();
  SearchSettings settings = settingsOf(0.8, 2);
  const SearchOutcome all = searchAllAngles(scene.frame, scene.table, scene.points, settings, nullptr);
  ASSERT_GT(all.boxes.size(), 3000u);
  EXPECT_EQ(all.threshold, 0.8);
  for (const int k : {1, 10, 500, 2000, static_cast<int>(all.boxes.size()) + 1}) {
    const std::size_t count = std::min<std::size_t>(k, all.boxes.size());
    const std::vector<ScoredBox> first(all.boxes.begin(), all.boxes.begin() + count);
    settings.search.top_k = k;
    // Starts: as low as it can, where the last of them is, somewhat over it, over all boxes.
    for (const double start :
         {-10.0, static_cast<double>(first.back().objectness), first.back().objectness + 0.01, 9.0}) {
      for (const int threads : {1, 2}) {
        settings.search.top_k_start = start;
        settings.threads = threads;
        const SearchOutcome top = searchAllAngles(scene.frame, scene.table, scene.points, settings, nullptr);
        ASSERT_NO_FATAL_FAILURE(expectSameBoxes(top.boxes, first)) << k << " from " << start << ", " << threads;
        EXPECT_EQ(top.threshold, count == all.boxes.size() ? 0.8 : first.back().objectness);
        EXPECT_LE(top.nodes, 2 * all.nodes);
      }
    }
  }
  settings.search.top_k = 500;
  settings.search.top_k_start = all.boxes[499].objectness;
  const SearchOutcome warm = searchAllAngles(scene.frame, scene.table, scene.points, settings, nullptr);
  EXPECT_LT(warm.nodes, 0.8 * all.nodes) << "what the frame before knew must save work";
}

TEST(RunningThreshold, NoneOfTheKBestIsBelowIt) {
  Dice dice(7);
  for (const int k : {1, 5, 100}) {
    RunningThreshold running(k, 0.8, 1.5);
    std::vector<float> added;
    for (int i = 0; i < 3000; ++i) {
      added.push_back(static_cast<float>(0.8 + 0.7 * dice.unit() * dice.unit()));
      running.add(added.back());
      if (static_cast<int>(added.size()) < k) {
        ASSERT_EQ(running.value(), 0.8);
        continue;
      }
      std::vector<float> sorted = added;
      std::nth_element(sorted.begin(), sorted.begin() + k - 1, sorted.end(), std::greater<float>());
      ASSERT_LE(running.value(), sorted[k - 1]);
    }
    EXPECT_GT(running.value(), 1.0) << "it must have risen";
  }
}

/// On real scenes: the very boxes and scores of the plain nested loop over every box, tight and wide, for several
/// weights and thresholds.
TEST(AngleSearch, FindsEveryBoxOfThePlainLoopInRealScenes) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  for (const std::string name : {"learn26", "test43"}) {
    SCOPED_TRACE(name);
    const auto read = loadSceneFolder(data + "/mosd/" + name, std::nullopt, InputConfig());
    ASSERT_TRUE(read.ok()) << read.status.message;
    const CueScene scene = cueScene(read.value);
    expectEveryBox(scene, settingsOf(0.8, 1), 1);
    SearchSettings wide = settingsOf(0.9, 1);
    wide.volume.min_extent_m = 1.0, wide.volume.min_height_m = 0.45;
    expectEveryBox(scene, wide, 9);
    SearchSettings faces = settingsOf(0.9, 1);
    faces.search.max_boxes_per_angle = 10000000;
    faces.objectness.three_face_area = true;
    faces.objectness.weight_edges = 0.3, faces.objectness.weight_outer = 0.7, faces.objectness.weight_free = 0;
    expectEveryBox(scene, faces, 6);
  }
}

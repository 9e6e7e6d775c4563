// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/tables.hpp"
#include "fixtures/figure.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;

namespace {

SceneResult resultOf(const std::string& scene, double recall, double ms, double peak_mib) {
  SceneResult result;
  result.scene = scene;
  result.method = "paper";
  result.object = Scores{};
  result.object->recall = recall;
  result.timings_ms = {{"table", 1}, {"total", ms}};
  result.peak_mib = peak_mib;
  return result;
}

}  // namespace

TEST(Tables, MeansMediansAndPeaksByGroup) {
  objectness::evaluation::Run run;
  run.levels = {Level::kObject, Level::kPart};
  run.methods = {{"paper", "", ""}};
  run.scenes = {{"a", "easy"}, {"b", "easy"}, {"c", "all"}, {"d", "easy"}};
  std::vector<SceneResult> results{resultOf("a", 0.5, 10, 30), resultOf("b", 1, 20, 50), resultOf("c", 0, 90, 40),
                                   resultOf("d", 0, 0, 99)};
  results[3].object.reset();  // nothing to find: not scored
  const auto rows = summarize(run, results);
  ASSERT_EQ(rows.size(), 2u);  // no parts scored; a group "all" has no row of its own
  EXPECT_EQ(rows[0].group, "easy");
  EXPECT_EQ(figure(rows[0].columns, "scenes"), 2);
  EXPECT_NEAR(figure(rows[0].columns, "R"), 0.75, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "ms"), 15, 1e-12);
  EXPECT_EQ(rows[1].group, "ALL");
  EXPECT_NEAR(figure(rows[1].columns, "R"), 0.5, 1e-12);
  EXPECT_NEAR(figure(rows[1].columns, "ms"), 20, 1e-12);
  EXPECT_NEAR(figure(rows[1].columns, "peak_mib"), 50, 1e-12);
  EXPECT_NE(toText(rows).find("paper      object     ALL"), std::string::npos) << toText(rows);
}

TEST(Tables, ProposalsAreMeansOverTheScenesThatHaveThem) {
  ProposalMetrics few, many;
  few.objects = 1;
  few.objectness.at_50[0] = 1;
  few.best_box_precision = 1;
  many.objects = 9;
  many.best_box_precision = 0.5;
  const Metrics pooled = poolProposals({toMetrics(few), {}, toMetrics(many)});
  EXPECT_NEAR(figure(pooled, "boxed_objects"), 10, 1e-12);
  EXPECT_NEAR(figure(pooled, "box50_1"), 0.5, 1e-12);
  EXPECT_NEAR(figure(pooled, "best_P"), 0.75, 1e-12);
  EXPECT_TRUE(poolProposals({{}, {}}).empty());
}

TEST(Tables, GapsAreMeansAndLargestOfTheScenesThatHaveThem) {
  const Metrics pooled = poolGaps({{{"selection_gap", 0.1}}, {}, {{"selection_gap", 0}, {"annealing_gap", 0.04}}});
  EXPECT_EQ(pooled.size(), 4u);
  EXPECT_NEAR(figure(pooled, "selection_gap"), 0.05, 1e-12);
  EXPECT_NEAR(figure(pooled, "selection_gap_max"), 0.1, 1e-12);
  EXPECT_NEAR(figure(pooled, "annealing_gap"), 0.04, 1e-12);
  EXPECT_NEAR(figure(pooled, "annealing_gap_max"), 0.04, 1e-12);
  EXPECT_TRUE(poolGaps({{}}).empty());
}

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/random_volumes.hpp"
#include "selection/global_selection.hpp"

using namespace objectness;
using objectness_test::Dice;

namespace {

constexpr int kPoints = 40;

/// Eq. 8 to 10 written out once more, point by point, straight from the paper.
double costByTheBook(const std::vector<CostHypothesis>& h, const SelectionConfig& c, const std::vector<bool>& x) {
  const auto has = [](const std::vector<int>& list, int p) {
    return std::find(list.begin(), list.end(), p) != list.end();
  };
  double cost = 0;
  for (std::size_t i = 0; i < h.size(); ++i) cost += c.lambda * h[i].free_space * x[i];
  for (int p = 0; p < kPoints; ++p) {
    int kappa = 0, beside = 0;
    double objectness = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
      if (!x[i]) continue;
      kappa += has(h[i].inside, p);
      objectness += has(h[i].inside, p) ? h[i].objectness : 0;
      beside += has(h[i].inside, p) || has(h[i].surroundings, p);  // b_eps holds b
    }
    if (kappa > 1) cost += c.weight_multiple * kappa;
    if (kappa == 1) cost -= c.weight_objectness * objectness;
    if (kappa == 0) cost += c.weight_unexplained * beside;
  }
  return cost;
}

CostProblem randomProblem(Dice& dice, int count) {
  CostProblem problem;
  problem.weights.assign(kPoints, 1);
  std::vector<CostHypothesis>& hypotheses = problem.hypotheses;
  hypotheses.resize(count);
  for (auto& h : hypotheses) {
    h.objectness = 0.9 + 0.6 * dice.unit();
    h.free_space = 20 * dice.unit();
    const int first = dice.below(kPoints - 4), last = std::min(kPoints, first + dice.between(2, 12));
    for (int p = std::max(0, first - 2); p < std::min(kPoints, last + 2); ++p) {
      (p >= first && p < last ? h.inside : h.surroundings).push_back(p);
    }
  }
  return problem;
}

}  // namespace

TEST(GlobalCost, EvaluateIsEq8) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Dice dice(seed);
    const CostProblem problem = randomProblem(dice, 7);
    SelectionConfig config;
    config.lambda = dice.unit(), config.weight_multiple = dice.unit(), config.weight_unexplained = 3 * dice.unit();
    std::vector<bool> active(7);
    for (int i = 0; i < 7; ++i) active[i] = dice.below(2);
    EXPECT_NEAR(GlobalCost::evaluate(problem, config, active), costByTheBook(problem.hypotheses, config, active), 1e-9);
  }
}

TEST(GlobalCost, EachCaseOfEq10) {
  SelectionConfig config;
  config.lambda = 10, config.weight_multiple = 0.5, config.weight_objectness = 1, config.weight_unexplained = 2;
  const CostProblem h = {{{0.9, 3, {0, 1, 2}, {3}}, {1.2, 0, {2}, {3, 4}}}, std::vector<int>(6, 1)};
  EXPECT_DOUBLE_EQ(GlobalCost::evaluate(h, config, {false, false}), 0);
  EXPECT_DOUBLE_EQ(GlobalCost::evaluate(h, config, {true, false}), 30 - 3 * 0.9 + 2);
  // 0 and 1 held once, 2 held twice, 3 beside both, 4 beside one, 5 beside none.
  EXPECT_DOUBLE_EQ(GlobalCost::evaluate(h, config, {true, true}), 30 - 2 * 0.9 + 0.5 * 2 + 2 * 2 + 2);
}

TEST(GlobalCost, FlipsAndSwapsKeepUpWithTheFullEvaluation) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    const CostProblem problem = randomProblem(dice, 9);
    const SelectionConfig config;
    GlobalCost cost(problem, config);
    for (int step = 0; step < 200; ++step) {
      const int i = dice.below(9), j = dice.below(9);
      const double before = cost.cost(), predicted = cost.flipDelta(i);
      cost.flip(i);
      ASSERT_NEAR(cost.cost(), before + predicted, 1e-9);
      if (dice.below(2) && i != j) cost.flip(j);
      ASSERT_NEAR(cost.cost(), GlobalCost::evaluate(problem, config, cost.active()), 1e-9);
    }
  }
}

TEST(CostProblem, MergingAlikePointsChangesNoCost) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    const CostProblem problem = randomProblem(dice, 6);
    const CostProblem merged = mergeAlikePoints(problem.hypotheses, kPoints);
    EXPECT_LT(merged.weights.size(), problem.weights.size());
    const SelectionConfig config;
    for (unsigned bits = 0; bits < 64; ++bits) {
      std::vector<bool> active(6);
      for (int i = 0; i < 6; ++i) active[i] = bits >> i & 1;
      ASSERT_NEAR(GlobalCost::evaluate(merged, config, active), GlobalCost::evaluate(problem, config, active), 1e-9);
    }
  }
}

TEST(CostProblem, OnePointForEachWayToLieInTheBoxes) {
  // 0 and 1 in both, 2 in the first only, 3 beside the first and in the second, 4 and 5 in none.
  const CostProblem merged = mergeAlikePoints({{1, 0, {0, 1, 2}, {3}}, {1, 0, {0, 1, 3}, {}}}, 6);
  EXPECT_EQ(merged.weights, (std::vector<int>{2, 1, 1}));
  EXPECT_EQ(merged.hypotheses[0].inside, (std::vector<int>{0, 1}));
  EXPECT_EQ(merged.hypotheses[0].surroundings, (std::vector<int>{2}));
  EXPECT_EQ(merged.hypotheses[1].inside, (std::vector<int>{0, 2}));
}

TEST(GlobalSelection, FindsTheBestOfAllSubsets) {
  int optimal = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    const CostProblem problem = randomProblem(dice, 10);
    SelectionConfig config;
    config.start_temperature = 50;
    double best = 0;
    for (unsigned bits = 0; bits < 1024; ++bits) {
      std::vector<bool> active(10);
      for (int i = 0; i < 10; ++i) active[i] = bits >> i & 1;
      best = std::min(best, GlobalCost::evaluate(problem, config, active));
    }
    const Selection selection = selectHypotheses(problem, config, 1);
    EXPECT_NEAR(selection.cost, GlobalCost::evaluate(problem, config, selection.active), 1e-9);
    EXPECT_GE(selection.cost, best - 1e-9);
    optimal += selection.cost < best + 1e-9;
  }
  EXPECT_EQ(optimal, 40);
}

TEST(GlobalSelection, KeepsTheBestEverMet) {
  // So hot that the walk is random to the end: what it met on the way must still not be lost.
  Dice dice(5);
  const CostProblem problem = randomProblem(dice, 10);
  SelectionConfig config;
  config.start_temperature = config.end_temperature = 1e6;
  const Selection selection = selectHypotheses(problem, config, 3);
  EXPECT_LE(selection.cost, 0);
  EXPECT_NEAR(selection.cost, GlobalCost::evaluate(problem, config, selection.active), 1e-6);
  config.iterations = 0;
  EXPECT_LE(selection.cost, selectHypotheses(problem, config, 3).cost + 1e-9) << "no worse than descent alone";
}

TEST(GlobalSelection, SameSeedSameSelection) {
  Dice dice(8);
  const CostProblem problem = randomProblem(dice, 12);
  const Selection a = selectHypotheses(problem, SelectionConfig(), 9);
  const Selection b = selectHypotheses(problem, SelectionConfig(), 9);
  EXPECT_EQ(a.active, b.active);
  EXPECT_EQ(a.cost, b.cost);
}

TEST(GlobalSelection, NothingToChooseFrom) {
  const Selection selection = selectHypotheses({}, SelectionConfig(), 1);
  EXPECT_TRUE(selection.active.empty());
  EXPECT_EQ(selection.cost, 0);
}

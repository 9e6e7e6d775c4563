// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "selection/set_packing.hpp"

using namespace objectness;

namespace {

constexpr std::int64_t kNoLimit = 100000000;

struct Kind {
  const char* name;
  int elements, sets, largest;
  bool whole_values;  ///< small whole numbers: many ties
};
const Kind kKinds[] = {{"sparse", 12, 10, 2, false},   {"dense", 6, 14, 4, false},   {"ties", 7, 13, 3, true},
                       {"one element", 1, 6, 1, true}, {"singles", 9, 14, 1, false}, {"large sets", 10, 14, 9, true}};

PackingProblem randomProblem(const Kind& kind, std::mt19937& random) {
  PackingProblem problem;
  problem.elements = kind.elements;
  for (int k = 0; k < kind.sets; ++k) {
    std::vector<int> set;
    const int size = 1 + static_cast<int>(random() % static_cast<unsigned>(kind.largest));
    for (int i = 0; i < size; ++i) set.push_back(static_cast<int>(random() % static_cast<unsigned>(kind.elements)));
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    problem.sets.push_back(set);
    problem.values.push_back(kind.whole_values ? static_cast<int>(random() % 8) - 2 : random() / 4294967296.0 * 7 - 2);
  }
  return problem;
}

/// The best value of all choices, tried one by one.
double bestOfAll(const PackingProblem& problem, std::size_t next = 0, unsigned taken = 0) {
  if (next == problem.sets.size()) return 0;
  double best = bestOfAll(problem, next + 1, taken);
  unsigned mask = 0;
  for (const int e : problem.sets[next]) mask |= 1u << e;
  if (!(mask & taken)) best = std::max(best, problem.values[next] + bestOfAll(problem, next + 1, taken | mask));
  return best;
}

/// Sets of positive value, no two of which share an element, and the value they have.
void expectValid(const Packing& packing, const PackingProblem& problem) {
  std::vector<int> owners(problem.elements, 0);
  double value = 0;
  for (const int k : packing.chosen) {
    EXPECT_GT(problem.values[k], 0);
    value += problem.values[k];
    for (const int e : problem.sets[k]) EXPECT_EQ(++owners[e], 1) << "element " << e << " in two sets";
  }
  EXPECT_TRUE(std::is_sorted(packing.chosen.begin(), packing.chosen.end()));
  EXPECT_NEAR(packing.value, value, 1e-9);
  EXPECT_LE(packing.value, packing.bound + 1e-9);
}

template <class Check>
void forRandomProblems(int each, Check&& check) {
  std::mt19937 random(5);
  for (const Kind& kind : kKinds) {
    for (int i = 0; i < each; ++i) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(i));
      const PackingProblem problem = randomProblem(kind, random);
      check(problem, bestOfAll(problem));
    }
  }
}

/// Every pair of neighbours on a ring of elements, all worth the same: bounds by shares say nothing.
PackingProblem ring(int elements) {
  PackingProblem problem;
  problem.elements = elements;
  for (int e = 0; e < elements; ++e) {
    const int next = (e + 1) % elements;
    problem.sets.push_back({std::min(e, next), std::max(e, next)});
    problem.values.push_back(1);
  }
  return problem;
}

}  // namespace

TEST(SetPacking, ExactEqualsTheBestOfAllChoices) {
  forRandomProblems(80, [](const PackingProblem& problem, double best) {
    const Packing packing = packExactly(problem, kNoLimit);
    expectValid(packing, problem);
    EXPECT_TRUE(packing.optimal);
    EXPECT_NEAR(packing.value, best, 1e-9);
    EXPECT_NEAR(packing.bound, best, 1e-9);
  });
}

TEST(SetPacking, ALimitLeavesAValidChoiceUnderTheBound) {
  for (const std::int64_t limit : {0, 1, 2, 5, 20}) {
    forRandomProblems(20, [&](const PackingProblem& problem, double best) {
      const Packing packing = packExactly(problem, limit);
      expectValid(packing, problem);
      EXPECT_GE(packing.bound, best - 1e-9);
      if (packing.optimal) {
        EXPECT_NEAR(packing.value, best, 1e-9);
      }
    });
  }
}

TEST(SetPacking, TheLimitIsForAllPartsTogether) {
  // Rings of their own: each is solved within a limit that all of them together exceed.
  const PackingProblem one = ring(9);
  std::int64_t enough = 1;
  while (!packExactly(one, enough).optimal) ++enough;
  PackingProblem many;
  for (int k = 0; k < 10; ++k) {
    for (std::vector<int> set : one.sets) {
      for (int& e : set) e += many.elements;
      many.sets.push_back(set);
      many.values.push_back(1);
    }
    many.elements += one.elements;
  }
  const Packing limited = packExactly(many, enough);
  expectValid(limited, many);
  EXPECT_FALSE(limited.optimal);
  EXPECT_TRUE(packExactly(many, 10 * enough).optimal);
}

TEST(SetPacking, AnnealingIsValidAndMostlyBest) {
  int problems = 0, best_found = 0;
  forRandomProblems(25, [&](const PackingProblem& problem, double best) {
    const Packing packing = packByAnnealing(problem, 3000, 1);
    expectValid(packing, problem);
    EXPECT_GE(packing.bound, best - 1e-9);
    EXPECT_LE(packing.value, best + 1e-9);
    if (packing.optimal) {
      EXPECT_NEAR(packing.value, best, 1e-9);
    }
    ++problems;
    best_found += packing.value > best - 1e-9;
  });
  EXPECT_GT(best_found, 0.95 * problems);
}

TEST(SetPacking, AnnealingDependsOnTheSeedOnly) {
  const PackingProblem problem = ring(40);  // a few moves leave it far from the best
  const Packing once = packByAnnealing(problem, 60, 3), again = packByAnnealing(problem, 60, 3);
  EXPECT_EQ(once.chosen, again.chosen);
  EXPECT_EQ(once.value, again.value);
  bool differs = false;
  for (std::uint32_t seed = 4; seed < 9; ++seed) differs |= packByAnnealing(problem, 60, seed).chosen != once.chosen;
  EXPECT_TRUE(differs);
}

TEST(SetPacking, TiesGoToTheFirstSets) {
  PackingProblem problem;
  problem.elements = 2;
  problem.sets = {{0}, {0}, {1}, {0, 1}, {1}};
  problem.values = {1, 1, 1, 2, 1};
  const Packing packing = packExactly(problem, kNoLimit);
  EXPECT_DOUBLE_EQ(packing.value, 2);
  EXPECT_EQ(packing.chosen, packExactly(problem, kNoLimit).chosen);
}

TEST(SetPacking, NothingToChoose) {
  PackingProblem worthless;
  worthless.elements = 3;
  worthless.sets = {{0}, {1, 2}, {2}};
  worthless.values = {0, -1, -0.5};
  for (const PackingProblem& problem : {PackingProblem{}, worthless}) {
    for (const Packing& packing : {packExactly(problem, kNoLimit), packByAnnealing(problem, 100, 1)}) {
      EXPECT_TRUE(packing.chosen.empty());
      EXPECT_EQ(packing.value, 0);
      EXPECT_EQ(packing.bound, 0);
      EXPECT_TRUE(packing.optimal);
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "selection/cost_problem.hpp"

#include <algorithm>
#include <unordered_map>

namespace objectness {
namespace {

/// The classes that the points of a list belong to, each once.
std::vector<int> classesOf(const std::vector<int>& list, const std::vector<int>& class_of) {
  std::vector<int> classes;
  for (const int p : list) classes.push_back(class_of[p]);
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

}  // namespace

CostProblem mergeAlikePoints(const std::vector<CostHypothesis>& hypotheses, int points) {
  // Every list splits each class it meets into the points on it and the others: what is left together is alike.
  std::vector<int> class_of(points, 0);
  int classes = 1;
  const auto split = [&](const std::vector<int>& list) {
    std::unordered_map<int, int> part_of;
    for (const int p : list) {
      const auto [part, is_new] = part_of.emplace(class_of[p], classes);
      if (is_new) ++classes;
      class_of[p] = part->second;
    }
  };
  for (const auto& h : hypotheses) {
    split(h.inside);
    split(h.surroundings);
  }

  // Class 0 is what no list named. Classes that were split up whole are empty; the others are numbered by first point.
  std::vector<int> number(classes, -1);
  CostProblem problem;
  for (int p = 0; p < points; ++p) {
    if (class_of[p] == 0) continue;
    int& index = number[class_of[p]];
    if (index < 0) {
      index = static_cast<int>(problem.weights.size());
      problem.weights.push_back(0);
    }
    ++problem.weights[index];
    class_of[p] = index;
  }
  for (const auto& h : hypotheses) {
    problem.hypotheses.push_back(
        {h.objectness, h.free_space, classesOf(h.inside, class_of), classesOf(h.surroundings, class_of)});
  }
  return problem;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "selection/set_packing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "common/disjoint_sets.hpp"

namespace objectness {
namespace {

/// Sets that share elements, directly or by way of others, are one part: parts can be solved one by one.
std::vector<std::vector<int>> connectedParts(const PackingProblem& problem) {
  DisjointSets sharing(problem.elements);
  for (std::size_t k = 0; k < problem.sets.size(); ++k) {
    if (problem.values[k] <= 0) continue;
    for (const int e : problem.sets[k]) sharing.join(e, problem.sets[k].front());
  }
  std::vector<std::vector<int>> parts(problem.elements);
  for (std::size_t k = 0; k < problem.sets.size(); ++k) {
    if (problem.values[k] > 0) parts[sharing.root(problem.sets[k].front())].push_back(static_cast<int>(k));
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); }), parts.end());
  return parts;
}

/// Best first, ties by index, so that the result does not depend on the order of equal sets in memory.
void sortByValue(const PackingProblem& problem, std::vector<int>& sets) {
  std::sort(sets.begin(), sets.end(), [&](int a, int b) {
    return problem.values[a] != problem.values[b] ? problem.values[a] > problem.values[b] : a < b;
  });
}

/// The most an element can add: its share of the best set that holds it.
std::vector<double> bestShares(const PackingProblem& problem) {
  std::vector<double> share(problem.elements, 0);
  for (std::size_t k = 0; k < problem.sets.size(); ++k) {
    for (const int e : problem.sets[k]) share[e] = std::max(share[e], problem.values[k] / problem.sets[k].size());
  }
  return share;
}

class BranchAndBound {
 public:
  BranchAndBound(const PackingProblem& problem, const std::vector<int>& part, std::int64_t max_nodes)
      : problem_(problem), nodes_left_(max_nodes), share_(bestShares(problem)), holding_(problem.elements) {
    std::vector<int> sorted = part;
    sortByValue(problem, sorted);
    std::vector<char> used(problem.elements, 0);
    for (const int k : sorted) {
      for (const int e : problem.sets[k]) {
        if (holding_[e].empty()) elements_.push_back(e);
        holding_[e].push_back(k);
      }
    }
    // Elements of few sets first: little to try at the top of the tree.
    std::stable_sort(elements_.begin(), elements_.end(),
                     [&](int a, int b) { return holding_[a].size() < holding_[b].size(); });
    free_.assign(problem.elements, 0);
    for (const int e : elements_) free_[e] = 1, open_ += share_[e];
    root_bound_ = open_;
    greedy(sorted);
  }

  void run() { branch(0, 0); }

  const std::vector<int>& chosen() const { return best_; }
  double value() const { return best_value_; }
  bool complete() const { return nodes_left_ > 0; }
  double bound() const { return complete() ? best_value_ : root_bound_; }
  std::int64_t nodesLeft() const { return nodes_left_; }

 private:
  bool fits(int k) const {
    return std::all_of(problem_.sets[k].begin(), problem_.sets[k].end(), [&](int e) { return free_[e]; });
  }

  void greedy(const std::vector<int>& sorted) {
    std::vector<char> saved = free_;
    for (const int k : sorted) {
      if (!fits(k)) continue;
      best_.push_back(k);
      best_value_ += problem_.values[k];
      for (const int e : problem_.sets[k]) free_[e] = 0;
    }
    free_ = saved;
  }

  void branch(std::size_t depth, double value) {
    if (--nodes_left_ <= 0) return;
    if (value > best_value_ + 1e-12) best_value_ = value, best_ = current_;
    while (depth < elements_.size() && !free_[elements_[depth]]) ++depth;
    if (depth == elements_.size() || value + open_ <= best_value_ + 1e-12) return;
    const int element = elements_[depth];
    for (const int k : holding_[element]) {
      if (!fits(k)) continue;
      for (const int e : problem_.sets[k]) free_[e] = 0, open_ -= share_[e];
      current_.push_back(k);
      branch(depth + 1, value + problem_.values[k]);
      current_.pop_back();
      for (const int e : problem_.sets[k]) free_[e] = 1, open_ += share_[e];
    }
    free_[element] = 0, open_ -= share_[element];
    branch(depth + 1, value);
    free_[element] = 1, open_ += share_[element];
  }

  const PackingProblem& problem_;
  std::int64_t nodes_left_;
  std::vector<double> share_;
  std::vector<std::vector<int>> holding_;  ///< sets of each element, best first
  std::vector<int> elements_;
  std::vector<char> free_;
  double open_ = 0;  ///< what the free elements can add at most
  double root_bound_ = 0;
  std::vector<int> current_, best_;
  double best_value_ = 0;
};

}  // namespace

Packing packExactly(const PackingProblem& problem, std::int64_t max_nodes) {
  Packing packing;
  packing.optimal = true;
  std::vector<std::vector<int>> parts = connectedParts(problem);
  // Small parts first: one that is too large for the limit leaves the others proven.
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  for (const std::vector<int>& part : parts) {
    BranchAndBound search(problem, part, max_nodes);
    search.run();
    max_nodes = search.nodesLeft();
    packing.chosen.insert(packing.chosen.end(), search.chosen().begin(), search.chosen().end());
    packing.value += search.value();
    packing.bound += search.bound();
    packing.optimal = packing.optimal && search.complete();
  }
  std::sort(packing.chosen.begin(), packing.chosen.end());
  return packing;
}

Packing packByAnnealing(const PackingProblem& problem, int iterations, std::uint32_t seed) {
  const std::vector<double> share = bestShares(problem);
  std::vector<int> sets, owner(problem.elements, -1);
  for (std::size_t k = 0; k < problem.sets.size(); ++k) {
    if (problem.values[k] > 0) sets.push_back(static_cast<int>(k));
  }
  Packing packing;
  packing.bound = std::accumulate(share.begin(), share.end(), 0.0);
  if (sets.empty()) {
    packing.optimal = true;
    return packing;
  }
  std::mt19937 random(seed);
  const auto uniform = [&] { return random() / 4294967296.0; };
  const double start = *std::max_element(problem.values.begin(), problem.values.end()), end = 1e-3 * start;
  std::vector<char> active(problem.sets.size(), 0), best(problem.sets.size(), 0);
  double value = 0;
  std::vector<int> thrown;
  for (int i = 0; i < iterations; ++i) {
    const double temperature = start * std::pow(end / start, i / static_cast<double>(iterations));
    const int k = sets[static_cast<std::size_t>(uniform() * sets.size())];
    thrown.clear();
    double delta = active[k] ? -problem.values[k] : problem.values[k];
    if (!active[k]) {
      for (const int e : problem.sets[k]) {
        if (owner[e] < 0 || std::find(thrown.begin(), thrown.end(), owner[e]) != thrown.end()) continue;
        thrown.push_back(owner[e]);
        delta -= problem.values[owner[e]];
      }
    }
    if (delta < 0 && uniform() >= std::exp(delta / temperature)) continue;
    if (active[k]) thrown.assign(1, k);
    for (const int old : thrown) {
      active[old] = 0;
      for (const int e : problem.sets[old]) owner[e] = -1;
    }
    if (thrown.size() != 1 || thrown[0] != k) {
      active[k] = 1;
      for (const int e : problem.sets[k]) owner[e] = k;
    }
    value += delta;
    if (value > packing.value + 1e-12) packing.value = value, best = active;
  }
  for (const int k : sets) {
    if (best[k]) packing.chosen.push_back(k);
  }
  packing.value = 0;  // from its definition: sums of changes drift
  for (const int k : packing.chosen) packing.value += problem.values[k];
  packing.optimal = packing.value >= packing.bound - 1e-12;
  return packing;
}

}  // namespace objectness

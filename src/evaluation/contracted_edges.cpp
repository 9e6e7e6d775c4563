// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/contracted_edges.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "common/disjoint_sets.hpp"

namespace objectness::evaluation {
namespace {

class Contraction {
 public:
  Contraction(int nodes, const std::vector<WeightedEdge>& edges) : weights_(nodes) {
    for (int k = 0; k < nodes; ++k) clusters_.create();
    for (const WeightedEdge& edge : edges) {
      if (edge.first == edge.second) continue;
      weights_[edge.first][edge.second] += edge.weight;
      weights_[edge.second][edge.first] += edge.weight;
    }
    for (int a = 0; a < nodes; ++a) {
      for (const auto& [b, weight] : weights_[a]) {
        if (a < b) offer(a, b, weight);
      }
    }
  }

  DisjointSets run() {
    while (!open_.empty()) {
      const auto [weight, minus_a, minus_b] = open_.top();
      open_.pop();
      const int a = -minus_a, b = -minus_b;
      const auto edge = weights_[a].find(b);
      if (edge != weights_[a].end() && edge->second == weight) contract(a, b);
    }
    return std::move(clusters_);
  }

 private:
  /// Nodes are negative, so that the smallest come first of equal weights.
  using Entry = std::tuple<double, int, int>;

  void offer(int a, int b, double weight) {
    if (weight > 0) open_.emplace(weight, -std::min(a, b), -std::max(a, b));
  }

  void contract(int kept, int gone) {
    clusters_.join(kept, gone);
    weights_[kept].erase(gone);
    for (const auto& [other, weight] : weights_[gone]) {
      weights_[other].erase(gone);
      if (other == kept) continue;
      const double sum = weights_[kept][other] += weight;
      weights_[other][kept] = sum;
      offer(kept, other, sum);
    }
    weights_[gone].clear();
  }

  std::vector<std::map<int, double>> weights_;  ///< of each node that is left, by its neighbour
  std::priority_queue<Entry> open_;             ///< entries of which the weight has changed since are void
  DisjointSets clusters_;
};

}  // namespace

std::vector<std::vector<int>> contractEdges(int nodes, const std::vector<WeightedEdge>& edges) {
  int count = 0;
  const std::vector<int> number = Contraction(nodes, edges).run().numbers(count);
  std::vector<std::vector<int>> clusters(count);
  for (int k = 0; k < nodes; ++k) clusters[number[k]].push_back(k);
  return clusters;
}

}  // namespace objectness::evaluation

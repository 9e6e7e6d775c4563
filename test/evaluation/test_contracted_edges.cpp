// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "evaluation/contracted_edges.hpp"

using namespace objectness::evaluation;

namespace {

using Clusters = std::vector<std::vector<int>>;

/// The definition, with all sums made afresh at every step.
Clusters contractPlainly(int nodes, const std::vector<WeightedEdge>& edges) {
  Clusters clusters;
  for (int k = 0; k < nodes; ++k) clusters.push_back({k});
  const auto between = [&](const std::vector<int>& a, const std::vector<int>& b) {
    double sum = 0;
    for (const WeightedEdge& edge : edges) {
      const auto in = [&](const std::vector<int>& c, int k) { return std::find(c.begin(), c.end(), k) != c.end(); };
      if ((in(a, edge.first) && in(b, edge.second)) || (in(b, edge.first) && in(a, edge.second))) sum += edge.weight;
    }
    return sum;
  };
  while (true) {
    double best = 0;
    std::size_t bi = 0, bj = 0;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        const double weight = between(clusters[i], clusters[j]);
        if (weight > best) best = weight, bi = i, bj = j;
      }
    }
    if (bi == bj) break;
    clusters[bi].insert(clusters[bi].end(), clusters[bj].begin(), clusters[bj].end());
    std::sort(clusters[bi].begin(), clusters[bi].end());
    clusters.erase(clusters.begin() + static_cast<long>(bj));
  }
  return clusters;
}

double valueOf(const std::vector<int>& cluster_of, const std::vector<WeightedEdge>& edges) {
  double value = 0;
  for (const WeightedEdge& edge : edges) {
    if (cluster_of[edge.first] == cluster_of[edge.second]) value += edge.weight;
  }
  return value;
}

double valueOf(int nodes, const Clusters& clusters, const std::vector<WeightedEdge>& edges) {
  std::vector<int> cluster_of(nodes, -1);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const int k : clusters[c]) cluster_of[k] = static_cast<int>(c);
  }
  return valueOf(cluster_of, edges);
}

/// Over all ways to part the nodes.
double bestValue(int nodes, const std::vector<WeightedEdge>& edges) {
  double best = 0;
  std::vector<int> cluster_of(nodes, 0);
  while (true) {
    best = std::max(best, valueOf(cluster_of, edges));
    int k = 0;
    while (k < nodes && ++cluster_of[k] == nodes) cluster_of[k++] = 0;
    if (k == nodes) return best;
  }
}

/// Weights are multiples of an eighth, so that sums do not depend on their order.
std::vector<WeightedEdge> randomEdges(int nodes, double share, std::mt19937& random) {
  std::vector<WeightedEdge> edges;
  for (int a = 0; a < nodes; ++a) {
    for (int b = a + 1; b < nodes; ++b) {
      if (random() % 1000 < 1000 * share) edges.push_back({a, b, (static_cast<int>(random() % 65) - 32) / 8.0});
    }
  }
  return edges;
}

}  // namespace

TEST(ContractedEdges, AreThoseOfTheDefinition) {
  std::mt19937 random(3);
  for (int graph = 0; graph < 200; ++graph) {
    const int nodes = 1 + static_cast<int>(random() % 14);
    std::vector<WeightedEdge> edges = randomEdges(nodes, 0.5, random);
    const Clusters plain = contractPlainly(nodes, edges);
    EXPECT_EQ(contractEdges(nodes, edges), plain) << "graph " << graph;
    std::shuffle(edges.begin(), edges.end(), random);
    for (WeightedEdge& edge : edges) {
      if (random() % 2) std::swap(edge.first, edge.second);
    }
    EXPECT_EQ(contractEdges(nodes, edges), plain) << "graph " << graph << ", the order of edges matters";
  }
}

TEST(ContractedEdges, AreSeldomFarFromTheBestClusters) {
  std::mt19937 random(8);
  double value = 0, best = 0;
  for (int graph = 0; graph < 30; ++graph) {
    const std::vector<WeightedEdge> edges = randomEdges(6, 0.7, random);
    const double found = valueOf(6, contractEdges(6, edges), edges), most = bestValue(6, edges);
    EXPECT_GE(found, 0);
    EXPECT_LE(found, most + 1e-9);
    value += found, best += most;
  }
  EXPECT_GT(value, 0.9 * best);
}

TEST(ContractedEdges, KeepWhatRepelsApartAndSumParallelEdges) {
  EXPECT_TRUE(contractEdges(0, {}).empty());
  EXPECT_EQ(contractEdges(3, {{0, 1, -1}, {1, 2, 0}}), (Clusters{{0}, {1}, {2}}));
  EXPECT_EQ(contractEdges(3, {{0, 2, 2}, {2, 0, -1}, {0, 1, -5}, {1, 2, 3}}), (Clusters{{0}, {1, 2}}));
  EXPECT_EQ(contractEdges(2, {{0, 1, 1}, {1, 0, -2}}), (Clusters{{0}, {1}})) << "parallel edges are summed up";
}

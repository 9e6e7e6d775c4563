// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace objectness::evaluation {

/// An edge of a graph. A positive weight speaks for one cluster, a negative one for two.
struct WeightedEdge {
  int first, second;
  double weight;
};

/// Correlation clustering by greedy additive edge contraction (Keuper, Levinkov, Bonneel, Lavoue, Brox & Andres,
/// "Efficient decomposition of image and mesh graphs by lifted multicuts", ICCV 2015, algorithm 1): the edge of largest
/// weight is contracted, edges that become parallel are summed up, until no weight is positive. Of equal weights the
/// edge between the smallest nodes comes first; a contracted edge goes on as its smaller node. Nodes are 0..nodes-1.
/// Returns the clusters by their smallest node, each ascending.
std::vector<std::vector<int>> contractEdges(int nodes, const std::vector<WeightedEdge>& edges);

}  // namespace objectness::evaluation

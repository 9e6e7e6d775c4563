// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/bottom_up.hpp"

#include <algorithm>

#include "common/parallel.hpp"
#include "grouping/propose_groups.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"

namespace objectness {

PieceGraph findPieceGraph(const Frame& frame, const Normals& normals, const Table& table,
                          const ObjectPoints& object_points, const Superpixels& superpixels, const PiecesConfig& pieces,
                          const LinksConfig& links, int threads) {
  PieceGraph graph;
  graph.pieces = labelPieces(frame, object_points, superpixels, pieces, threads);
  inParallel(
      threads, [&] { describePieces(frame, normals, superpixels, graph.pieces); },
      [&] { graph.borders = findBorders(frame, object_points, graph.pieces); });
  graph.pairs =
      findPairEvidence(frame, normals, table, object_points, superpixels, graph.pieces, graph.borders, links, threads);
  return graph;
}

std::vector<GroupHypothesis> proposeObjects(const Frame& frame, const Table& table, const EdgeMap& edges,
                                            const PieceGraph& graph, const std::vector<Link>& links,
                                            const GroupingConfig& config, int threads,
                                            const std::vector<std::vector<int>>& also) {
  const GroupLimits limits{static_cast<std::size_t>(config.max_groups),
                           static_cast<std::size_t>(config.max_all_groups)};
  auto groups = proposeGroups(graph.pieces.count(), links, limits, config.kinds);
  groups.insert(groups.end(), also.begin(), also.end());
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  auto described = describeGroups({frame, table, edges, graph.pieces, graph.borders, links}, groups, threads);
  for (GroupHypothesis& group : described) group.cues = config.cues(group.cues);
  return described;
}

void judgeGroups(const LearnedObjectness& model, std::vector<GroupHypothesis>& groups, int threads) {
  parallelFor(static_cast<int>(groups.size()), threads,
              [&](int i) { groups[i].objectness = model.group.predict(cueValues(groups[i].cues)); });
}

}  // namespace objectness

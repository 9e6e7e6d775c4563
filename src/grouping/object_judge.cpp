// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/object_judge.hpp"

#include "grouping/rule_based_scores.hpp"

namespace objectness {

const LearnedObjectness* judgeOf(const Config& config, const LearnedObjectness* given) {
  if (!config.grouping.learned) return nullptr;
  return given ? given : &defaultModel();
}

std::vector<Link> judgeLinks(const PieceGraph& graph, const LearnedObjectness* model, int threads) {
  return model ? judgePairs(graph.pairs, graph.borders, *model, threads)
               : scorePairsByRule(graph.pairs, graph.pieces, graph.borders);
}

void judgeObjects(const Config& config, const LearnedObjectness* model, std::vector<GroupHypothesis>& groups) {
  if (model) {
    judgeGroups(*model, groups, config.runtime.threads);
  } else {
    scoreGroupsByRule(config.objectness, config.volume.voxel_m,
                      config.grouping.least_objectness - config.filter.threshold, groups);
  }
}

}  // namespace objectness

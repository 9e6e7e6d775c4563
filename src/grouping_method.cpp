// SPDX-License-Identifier: BSD-3-Clause
#include "grouping_method.hpp"

#include <algorithm>
#include <optional>

#include "grouping/bottom_up.hpp"
#include "grouping/group_cost.hpp"
#include "grouping/object_judge.hpp"
#include "grouping/standing_groups.hpp"
#include "selection/hypotheses.hpp"

namespace objectness {
namespace {

/// Best objectness first.
std::vector<RankedBox> rankedBoxes(const std::vector<GroupHypothesis>& groups) {
  std::vector<RankedBox> ranked;
  for (const GroupHypothesis& group : groups) ranked.push_back({group.box, group.objectness});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedBox& a, const RankedBox& b) { return a.objectness > b.objectness; });
  return ranked;
}

/// The groups that explain the scene best, none of which share a piece.
std::vector<int> packGroups(const PieceGraph& graph, const std::vector<Link>& links,
                            const std::vector<GroupHypothesis>& groups, const Config& config, const Stages& stage) {
  PackingProblem problem;
  const Packing packing = stage("selection", [&] {
    problem = packingProblem(graph.pieces.count(), links, groups, config.grouping);
    return selectGroups(problem, config.grouping, config.runtime.seed);
  });
  stage.report().selection_proven = packing.optimal;
  stage.report().selection_value = packing.value;
  stage.report().selection_bound = packing.bound;
  stage.report().selection_gap = packing.gap();
  if (config.grouping.compare_annealing) {
    Packing annealed =
        stage("annealing", [&] { return packByAnnealing(problem, config.grouping.iterations, config.runtime.seed); });
    annealed.bound = packing.bound;
    annealed.optimal = packing.optimal && annealed.value >= packing.value;
    stage.report().annealing_gap = annealed.gap();
  }
  return packing.chosen;
}

/// Sec. 4.2 over groups: the paper's cost, annealed.
std::vector<int> annealGroups(const Frame& frame, const Table& table, const Pieces& pieces,
                              const std::vector<GroupHypothesis>& groups, const Config& config, const Stages& stage) {
  const Selection selection = stage("selection", [&] {
    const CostProblem problem =
        groupCostProblem(frame, table, pieces, groups, config.selection, {config.objectness, config.volume.voxel_m});
    return selectHypotheses(problem, config.selection, config.runtime.seed);
  });
  stage.report().selection_cost = selection.cost;
  std::vector<int> chosen;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (selection.active[k]) chosen.push_back(static_cast<int>(k));
  }
  return chosen;
}

}  // namespace

void groupPieces(const Frame& frame, const Config& config, const LearnedObjectness* model, const GroupingMemory* memory,
                 const Stages& stage, Segmentation& result) {
  const LearnedObjectness* judge = judgeOf(config, model);
  const PieceGraph graph = stage("pieces", [&] {
    return findPieceGraph(frame, result.normals, result.table, result.object_points, result.superpixels, config.pieces,
                          config.links, config.runtime.threads);
  });
  stage.report().pieces = graph.pieces.count();
  stage.report().pairs = graph.pairs.size();

  std::vector<Link> links;
  const std::vector<GroupHypothesis> groups = stage("groups", [&] {
    links = judgeLinks(graph, judge, config.runtime.threads);
    std::optional<RememberedGroups> remembered;
    if (memory) {
      remembered.emplace(graph.pieces, *memory);
      remembered->weighLinks(config.grouping.memory_log_odds, links);
    }
    std::vector<GroupHypothesis> proposed =
        proposeObjects(frame, result.table, result.edges, graph, links, config.grouping, config.runtime.threads,
                       remembered ? remembered->groups() : std::vector<std::vector<int>>{});
    judgeObjects(config, judge, proposed);
    if (remembered) remembered->compare(proposed);
    return proposed;
  });
  stage.report().hypotheses = groups.size();
  result.proposals = rankedBoxes(groups);

  std::vector<int> chosen = config.grouping.paper_cost
                                ? annealGroups(frame, result.table, graph.pieces, groups, config, stage)
                                : packGroups(graph, links, groups, config, stage);
  const std::vector<int> standing = standingGroups(frame, result.table, result.object_points, graph.pieces, links,
                                                   groups, chosen, config.grouping, config.runtime.seed);
  chosen.insert(chosen.end(), standing.begin(), standing.end());
  result.segments = stage("segments", [&] { return cutGroups(graph.pieces, groups, chosen, config.segments); });
}

}  // namespace objectness

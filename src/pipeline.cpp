// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/pipeline.hpp"

#include <algorithm>
#include <optional>

#include "doubtful_scale.hpp"
#include "finished_segments.hpp"
#include "front_end.hpp"
#include "grouping/bottom_up.hpp"
#include "grouping/group_cost.hpp"
#include "grouping/object_judge.hpp"
#include "grouping/standing_groups.hpp"
#include "guarded_segmentation.hpp"
#include "needed_resolution.hpp"
#include "remembering_segment.hpp"
#include "search/angle_search.hpp"
#include "selection/hypotheses.hpp"

namespace objectness {
namespace {

SearchSettings searchSettings(const Config& config) {
  return {config.volume, config.search, config.objectness, config.filter.threshold, config.runtime.threads};
}

std::vector<SelectedBox> chosenBoxes(const Hypotheses& candidates, const Selection& selection,
                                     const SearchOutcome& search) {
  std::vector<SelectedBox> chosen;
  for (std::size_t i = 0; i < candidates.boxes.size(); ++i) {
    if (selection.active[i]) chosen.push_back({candidates.boxes[i], search.grids[candidates.boxes[i].box.angle]});
  }
  return chosen;
}

std::vector<RankedBox> rankedBoxes(const Hypotheses& candidates, const SearchOutcome& search,
                                   const Eigen::Isometry3d& T_table_camera) {
  std::vector<RankedBox> ranked;
  for (const ScoredBox& scored : candidates.boxes) {
    ranked.push_back({orientedBox(scored.box, search.grids[scored.box.angle], T_table_camera), scored.objectness});
  }
  return ranked;
}

/// Best objectness first.
std::vector<RankedBox> rankedBoxes(const std::vector<GroupHypothesis>& groups) {
  std::vector<RankedBox> ranked;
  for (const GroupHypothesis& group : groups) ranked.push_back({group.box, group.objectness});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedBox& a, const RankedBox& b) { return a.objectness > b.objectness; });
  return ranked;
}

/// The paper: boxes of an exhaustive sampling, weighed by hand.
void searchBoxes(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result) {
  const CuePoints points = stage("cue_points", [&] {
    return collectCuePoints(frame, result.table, result.object_points, result.edges, result.superpixels);
  });
  stage.count("object_points", points.points.size());
  stage.count("edge_points", points.edges.size());

  // Sec. 2.1, 2.2 and 3.5: integral volumes for every angle, every box of the sampling scored.
  const SearchOutcome search = stage("search", [&] {
    return searchAllAngles(frame, result.table, points, searchSettings(config), stage.cancelFlag());
  });
  stage.count("boxes_sampled", search.sampled);
  stage.count("boxes_scored", search.scored);
  stage.count("boxes_passed", search.passed);
  stage.count("boxes_bounded", search.unbounded.empty());
  stage.value("search_threshold", search.threshold);
  if (!search.status.ok()) {
    result.status = search.status;
    return;
  }

  // Sec. 4.1: clusters, conflicts, non-maximum suppression.
  const Hypotheses candidates = stage("filter", [&] {
    return filterByObjectness(search.boxes, search.grids, points.points, config.filter, config.selection,
                              config.runtime.threads);
  });
  stage.count("hypotheses", candidates.boxes.size());
  result.proposals = rankedBoxes(candidates, search, result.table.T_table_camera);

  // Sec. 4.2: the globally consistent choice.
  const Selection selection =
      stage("selection", [&] { return selectHypotheses(candidates.problem, config.selection, config.runtime.seed); });
  stage.value("selection_cost", selection.cost);

  // Sec. 4: a segment is what falls within a selected box.
  result.segments = stage("segments", [&] {
    return cutSegments(frame, result.table.T_table_camera, points, chosenBoxes(candidates, selection, search),
                       config.filter.box_margin_m, config.segments, config.runtime.threads);
  });
}

/// The groups that explain the scene best, none of which share a piece.
std::vector<int> packGroups(const PieceGraph& graph, const std::vector<Link>& links,
                            const std::vector<GroupHypothesis>& groups, const Config& config, const Stages& stage) {
  PackingProblem problem;
  const Packing packing = stage("selection", [&] {
    problem = packingProblem(graph.pieces.count(), links, groups, config.grouping);
    return selectGroups(problem, config.grouping, config.runtime.seed);
  });
  stage.count("selection_proven", packing.optimal);
  stage.value("selection_value", packing.value);
  stage.value("selection_bound", packing.bound);
  stage.value("selection_gap", packing.gap());
  if (config.grouping.compare_annealing) {
    Packing annealed =
        stage("annealing", [&] { return packByAnnealing(problem, config.grouping.iterations, config.runtime.seed); });
    annealed.bound = packing.bound;
    annealed.optimal = packing.optimal && annealed.value >= packing.value;
    stage.value("annealing_gap", annealed.gap());
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
  stage.value("selection_cost", selection.cost);
  std::vector<int> chosen;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (selection.active[k]) chosen.push_back(static_cast<int>(k));
  }
  return chosen;
}

/// Past the paper: groups of superpixels of any height and tilt, judged by what was learned, or without a model by
/// hand.
void groupPieces(const Frame& frame, const Config& config, const LearnedObjectness* model, const GroupingMemory* memory,
                 const Stages& stage, Segmentation& result) {
  const PieceGraph graph = stage("pieces", [&] {
    return findPieceGraph(frame, result.normals, result.table, result.object_points, result.superpixels, config.pieces,
                          config.links, config.runtime.threads);
  });
  stage.count("pieces", graph.pieces.count());
  stage.count("pairs", graph.pairs.size());

  std::vector<Link> links;
  const std::vector<GroupHypothesis> groups = stage("groups", [&] {
    links = judgeLinks(graph, model, config.runtime.threads);
    std::optional<RememberedGroups> remembered;
    if (memory) {
      remembered.emplace(graph.pieces, *memory);
      remembered->weighLinks(config.grouping.memory_log_odds, links);
    }
    std::vector<GroupHypothesis> proposed =
        proposeObjects(frame, result.table, result.edges, graph, links, config.grouping, config.runtime.threads,
                       remembered ? remembered->groups() : std::vector<std::vector<int>>{});
    judgeObjects(config, model, proposed);
    if (remembered) remembered->compare(proposed);
    return proposed;
  });
  stage.count("hypotheses", groups.size());
  result.proposals = rankedBoxes(groups);

  std::vector<int> chosen = config.grouping.paper_cost
                                ? annealGroups(frame, result.table, graph.pieces, groups, config, stage)
                                : packGroups(graph, links, groups, config, stage);
  const std::vector<int> standing = standingGroups(frame, result.table, result.object_points, graph.pieces, links,
                                                   groups, chosen, config.grouping, config.runtime.seed);
  chosen.insert(chosen.end(), standing.begin(), standing.end());
  result.segments = stage("segments", [&] { return cutGroups(graph.pieces, groups, chosen, config.segments); });
}

void remarkOnScale(const Frame& frame, Segmentation& result) {
  const std::string remark = doubtfulScale(frame, result);
  if (!remark.empty()) result.report.remarks.push_back(remark);
}

/// Fills `result` as far as it gets.
void run(const Frame& frame, const Config& config, const LearnedObjectness* model, const GroupingMemory* memory,
         const std::atomic<bool>* cancel, Segmentation& result) {
  const Stages stage(cancel, result.report);
  observeScene(frame, config, stage, result);
  if (!result.status.ok()) {
    remarkOnScale(frame, result);
    return;
  }
  if (config.grouping.enabled) {
    groupPieces(frame, config, judgeOf(config, model), memory, stage, result);
  } else {
    searchBoxes(frame, config, stage, result);
  }
  if (!result.status.ok()) return;
  finishSegments(frame, config, stage, result);
  remarkOnScale(frame, result);
}

}  // namespace

Segmentation segmentRemembering(const Frame& frame, const Config& config, const LearnedObjectness* model,
                                const GroupingMemory* memory, const std::atomic<bool>* cancel) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::vector<std::string> problems = validate(config);
    if (!problems.empty()) {
      result.status = Status::error(StatusCode::kBadConfig, problems.front());
      return;
    }
    try {
      atNeededResolution(frame, config, result,
                         [&](const Frame& seen) { run(seen, config, model, memory, cancel, result); });
    } catch (const Cancelled&) {
      result.status = Status::error(StatusCode::kCancelled, "cancelled between stages");
    }
  });
}

Segmentation segment(const Frame& frame, const Config& config, const std::atomic<bool>* cancel) {
  return segmentRemembering(frame, config, nullptr, nullptr, cancel);
}

Segmentation segment(const Frame& frame, const Config& config, const LearnedObjectness& model,
                     const std::atomic<bool>* cancel) {
  return segmentRemembering(frame, config, &model, nullptr, cancel);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "box_method.hpp"

#include "search/angle_search.hpp"
#include "segments/segments.hpp"
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

}  // namespace

void searchBoxes(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result) {
  const CuePoints points = stage("cue_points", [&] {
    return collectCuePoints(frame, result.table, result.object_points, result.edges, result.superpixels);
  });
  stage.report().object_points = points.points.size();
  stage.report().edge_points = points.edges.size();

  // Sec. 2.1, 2.2 and 3.5: integral volumes for every angle, every box of the sampling scored.
  const SearchOutcome search = stage("search", [&] {
    return searchAllAngles(frame, result.table, points, searchSettings(config), stage.cancelFlag());
  });
  stage.report().boxes_sampled = search.sampled;
  stage.report().boxes_scored = search.scored;
  stage.report().boxes_passed = search.passed;
  stage.report().boxes_bounded = search.unbounded.empty();
  stage.report().search_threshold = search.threshold;
  if (!search.status.ok()) {
    result.status = search.status;
    return;
  }

  // Sec. 4.1: clusters, conflicts, non-maximum suppression.
  const Hypotheses candidates = stage("filter", [&] {
    return filterByObjectness(search.boxes, search.grids, points.points, config.filter, config.selection,
                              config.runtime.threads);
  });
  stage.report().hypotheses = candidates.boxes.size();
  result.proposals = rankedBoxes(candidates, search, result.table.T_table_camera);

  // Sec. 4.2: the globally consistent choice.
  const Selection selection =
      stage("selection", [&] { return selectHypotheses(candidates.problem, config.selection, config.runtime.seed); });
  stage.report().selection_cost = selection.cost;

  // Sec. 4: a segment is what falls within a selected box.
  result.segments = stage("segments", [&] {
    return cutSegments(frame, result.table.T_table_camera, points, chosenBoxes(candidates, selection, search),
                       config.filter.box_margin_m, config.pipeline.method == SegmentationMethod::kPaper,
                       config.segments, config.runtime.threads);
  });
}

}  // namespace objectness

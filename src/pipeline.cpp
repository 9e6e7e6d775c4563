// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/pipeline.hpp"

#include "guarded_segmentation.hpp"
#include "objectness_segmentation/search/angle_search.hpp"
#include "objectness_segmentation/selection/hypotheses.hpp"

namespace objectness {
namespace {

/// Thrown between stages only, and caught in segment().
struct Cancelled {};

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

/// The paper, stage by stage. Fills `result` as far as it gets.
void run(const Frame& frame, const Config& config, const std::atomic<bool>* cancel, Segmentation& result) {
  const auto stage = [&](const char* name, auto&& work) {
    if (cancel && *cancel) throw Cancelled();
    const StageTimer timer(result.report.timings_ms, name);
    return work();
  };
  const auto count = [&](const char* name, auto value) { result.report.counts.emplace_back(name, value); };

  // Sec. 2: the dominant plane, and the points above it.
  const Normals normals = stage("normals", [&] { return estimateNormals(frame, config.normals); });
  const Result<Table> found = stage("table", [&] { return findTable(frame, normals, config.table); });
  const Table& table = result.table = found.value;
  if (!found.ok()) {
    result.status = found.status;
    return;
  }
  const ObjectPoints& above = result.object_points =
      stage("object_points", [&] { return findObjectPoints(frame, normals, table, config.object_points); });

  // Sec. 2.3 and 3.1 to 3.3: edges and smooth superpixels.
  result.edges = stage("edges", [&] { return findEdges(frame, normals, table, above, config.edges); });
  result.superpixels =
      stage("superpixels", [&] { return findSuperpixels(frame, normals, table, above, config.superpixels); });
  const CuePoints points = collectCuePoints(frame, table, above, result.edges, result.superpixels);
  count("object_points", points.points.size());
  count("edge_points", points.edges.size());
  count("superpixels", result.superpixels.count);

  // Sec. 2.1, 2.2 and 3.5: integral volumes for every angle, every box of the sampling scored.
  const SearchOutcome search =
      stage("search", [&] { return searchAllAngles(frame, table, points, searchSettings(config), cancel); });
  count("boxes_sampled", search.sampled);
  count("boxes_scored", search.scored);
  count("boxes_passed", search.passed);
  if (!search.status.ok()) {
    result.status = search.status;
    return;
  }

  // Sec. 4.1: clusters, conflicts, non-maximum suppression.
  const Hypotheses candidates = stage("filter", [&] {
    return filterByObjectness(search.boxes, search.grids, points.points, config.filter, config.selection,
                              config.runtime.threads);
  });
  result.proposals = rankedBoxes(candidates, search, table.T_table_camera);
  count("hypotheses", candidates.boxes.size());

  // Sec. 4.2: the globally consistent choice.
  const Selection selection =
      stage("selection", [&] { return selectHypotheses(candidates.problem, config.selection, config.runtime.seed); });

  // Sec. 4: a segment is what falls within a selected box.
  result.segments = stage("segments", [&] {
    return cutSegments(frame, table.T_table_camera, points, chosenBoxes(candidates, selection, search),
                       config.filter.box_margin_m, config.segments);
  });
  result.labels = labelImage(above.on_table, result.segments);
  count("segments", result.segments.size());
}

}  // namespace

Segmentation segment(const Frame& frame, const Config& config, const std::atomic<bool>* cancel) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::vector<std::string> problems = validate(config);
    if (!problems.empty()) {
      result.status = Status::error(StatusCode::kBadConfig, problems.front());
      return;
    }
    try {
      run(frame, config, cancel, result);
    } catch (const Cancelled&) {
      result.status = Status::error(StatusCode::kCancelled, "cancelled between stages");
    }
  });
}

}  // namespace objectness

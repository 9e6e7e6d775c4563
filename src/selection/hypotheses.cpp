// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/hypotheses.hpp"

#include <cmath>
#include <optional>

#include "objectness_segmentation/common/parallel.hpp"
#include "objectness_segmentation/selection/scene_points.hpp"

namespace objectness {

Hypotheses filterByObjectness(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                              const std::vector<Eigen::Vector3f>& points, const FilterConfig& filter,
                              const SelectionConfig& selection, int threads) {
  Hypotheses result;
  if (boxes.empty()) return result;
  const double top_m = grids.front().nz * grids.front().voxel_m;
  const std::vector<Eigen::Vector3f> scene = thinPoints(points, selection.point_spacing_m, top_m);

  std::vector<std::optional<PointOverlap>> built(grids.size());
  parallelFor(static_cast<int>(grids.size()), threads,
              [&](int angle) { built[angle].emplace(scene, grids[angle], filter.box_margin_m); });
  std::vector<PointOverlap> overlaps;
  for (auto& overlap : built) overlaps.push_back(std::move(*overlap));

  std::vector<CostHypothesis> hypotheses;
  const int ring = static_cast<int>(std::lround(selection.ring_m / grids.front().voxel_m));
  for (const BoxHypothesis& kept : filterBoxes(boxes, grids, overlaps, filter)) {
    const ScoredBox& scored = kept.scored;
    CostHypothesis hypothesis;
    hypothesis.objectness = scored.objectness;
    hypothesis.free_space = selection.free_space_in_voxels ? scored.cues.free_voxels : scored.cues.free_space;
    hypothesis.inside = listPoints(kept.points);
    PointSet beside = overlaps[scored.box.angle].inside(scored.box, ring, ring);
    for (std::size_t i = 0; i < beside.size(); ++i) beside[i] &= ~kept.points[i];
    hypothesis.surroundings = listPoints(beside);
    result.boxes.push_back(scored);
    hypotheses.push_back(std::move(hypothesis));
  }
  result.problem = mergeAlikePoints(hypotheses, static_cast<int>(scene.size()));
  return result;
}

}  // namespace objectness

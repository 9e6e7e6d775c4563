// SPDX-License-Identifier: BSD-3-Clause
#include "selection/hypotheses.hpp"

#include <cmath>
#include <optional>

#include "common/parallel.hpp"
#include "selection/scene_points.hpp"
#include "selection/suppression.hpp"

namespace objectness {

Hypotheses filterByObjectness(const std::vector<ScoredBox>& boxes, const std::vector<Grid>& grids,
                              const std::vector<Eigen::Vector3f>& points, const FilterConfig& filter,
                              const SelectionConfig& selection, int threads) {
  Hypotheses result;
  if (boxes.empty()) return result;
  const double top_m = grids.front().nz * grids.front().voxel_m;
  const std::vector<Eigen::Vector3f> scene = inBitOrder(thinPoints(points, selection.point_spacing_m, top_m));
  const PointLayout layout(static_cast<int>(scene.size()));
  result.problem.layout = layout;

  std::vector<std::optional<BoxPoints>> built(grids.size());
  parallelFor(static_cast<int>(grids.size()), threads,
              [&](int angle) { built[angle].emplace(scene, layout, grids[angle], filter.box_margin_m); });
  std::vector<BoxPoints> points_of;
  for (auto& one : built) points_of.push_back(std::move(*one));

  const int ring = static_cast<int>(std::lround(selection.ring_m / grids.front().voxel_m));
  for (SurvivingBox& kept : suppressBoxes(boxes, grids, points_of, layout, filter, threads)) {
    const ScoredBox& scored = kept.scored;
    PointBits beside{0, std::vector<std::uint64_t>(layout.words(), 0)};
    points_of[scored.box.angle].inside(scored.box, ring, ring, beside);
    for (std::size_t i = 0; i < beside.words.size(); ++i) beside.words[i] &= ~kept.points.words[i];
    result.boxes.push_back(scored);
    result.problem.hypotheses.push_back(
        {scored.objectness, selection.free_space_in_voxels ? scored.cues.free_voxels : scored.cues.free_space,
         std::move(kept.points), std::move(beside)});
  }
  return result;
}

}  // namespace objectness

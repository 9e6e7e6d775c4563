// SPDX-License-Identifier: BSD-3-Clause
#include "objectness/objectness.hpp"

#include <algorithm>
#include <cmath>

#include "objectness/cue_scores.hpp"

namespace objectness {

double objectness(const CueValues& cues, const ObjectnessConfig& config) {
  return config.weight_edges * cues.edge_density + config.weight_outer * cues.outer_edges * cues.straddling +
         config.weight_free * cues.free_space + config.constant;
}

Ring ringOf(const ObjectnessConfig& config, double voxel_m) {
  return {static_cast<int>(std::lround(config.ring_xy_m / voxel_m)),
          static_cast<int>(std::lround(config.ring_z_m / voxel_m))};
}

std::optional<ScoredBox> scoreBox(const CueVolumes& volumes, const Box& b, const Ring& ring,
                                  const ObjectnessConfig& config) {
  const int edges = volumes.edges.count(b.x0, b.x1, b.y0, b.y1, b.height);
  if (edges < config.min_edge_voxels) return std::nullopt;

  const int occupied = volumes.occupied.count(b.x0, b.x1, b.y0, b.y1, b.height);
  if (occupied < config.min_occupied_voxels) return std::nullopt;
  const int below_top = b.height - std::max(b.height / 3, 1);
  const int top = occupied - volumes.occupied.count(b.x0, b.x1, b.y0, b.y1, below_top);
  if (top < config.min_top_share * occupied) return std::nullopt;

  double sum = 0;
  int labelled = 0;
  for (const auto& superpixel : volumes.superpixels) {
    const int inside = superpixel.count(b.x0, b.x1, b.y0, b.y1, b.height);
    sum += straddling(inside, superpixel.total());
    labelled += inside;
  }

  const double area = config.three_face_area ? threeFaceArea(b) : visibleArea(b, volumes.viewpoint);
  const int expanded =
      volumes.edges.count(std::max(b.x0 - ring.xy, 0), std::min(b.x1 + ring.xy, volumes.grid.nx),
                          std::max(b.y0 - ring.xy, 0), std::min(b.y1 + ring.xy, volumes.grid.ny), b.height + ring.z);
  const int filled = volumes.filled.count(b.x0, b.x1, b.y0, b.y1, b.height);
  CueValues cues;
  cues.edge_density = static_cast<float>(std::min(edgeDensity(edges, area), config.max_edge_density));
  cues.outer_edges = static_cast<float>(outerEdges(edges, expanded));
  cues.straddling = static_cast<float>(straddling(sum, labelled));
  cues.free_space = static_cast<float>(freeSpace(b.volume(), filled, area));
  cues.free_voxels = static_cast<int>(b.volume() - filled);
  if (cues.straddling < config.min_straddling) return std::nullopt;
  return ScoredBox{b, cues, static_cast<float>(objectness(cues, config))};
}

}  // namespace objectness

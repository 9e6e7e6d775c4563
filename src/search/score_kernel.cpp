// SPDX-License-Identifier: BSD-3-Clause
#include "search/score_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

inline int countAt(const CornerColumns& c, int h) {
  return static_cast<std::uint16_t>(c.p11[h] - c.p01[h] - c.p10[h] + c.p00[h]);
}

}  // namespace

OBJECTNESS_CLONES("avx2")
void scoreHeights(const BoxColumns& box, const SuperpixelColumns* superpixels, int count,
                  const ScoreConstants& constants, HeightRange heights, const ScoreColumns& scores) {
  const int first = heights.first, last = heights.last;
  double* sum = scores.sum;
  int* labelled = scores.labelled;
  for (int h = first; h <= last; ++h) sum[h] = 0.0, labelled[h] = 0;
  for (int s = 0; s < count; ++s) {
    const CornerColumns columns = superpixels[s].columns;
    const double total = superpixels[s].total;
    for (int h = first; h <= last; ++h) {
      const int inside = countAt(columns, h);
      sum[h] += static_cast<double>(inside) * inside / total;
      labelled[h] += inside;
    }
  }
  const CornerColumns occupied = box.occupied;
  for (int h = 0; h <= last; ++h) scores.occupied[h] = countAt(occupied, h);

  const CornerColumns edges = box.edges, ring = box.ring, filled = box.filled;
  const ScoreConstants k = constants;
  const double size_x = box.size_x, size_y = box.size_y;
  const double side_x = box.side_x_visible ? size_y : 0.0, side_y = box.side_y_visible ? size_x : 0.0;
  const int base = static_cast<int>(size_x * size_y);
  for (int h = first; h <= last; ++h) {
    const double height = h;
    const double area = side_x * height + side_y * height + size_x * size_y * k.top_visible[h];
    const int edges_inside = countAt(edges, h), edges_around = countAt(ring, h);
    const int free = base * h - countAt(filled, h);
    const double divisor = area > 0 ? area : 1.0;
    const double density = area > 0 ? edges_inside / divisor : 0.0;
    const float edge_density = static_cast<float>(k.max_edge_density < density ? k.max_edge_density : density);
    const float outer_edges = static_cast<float>(
        edges_around > 0 ? static_cast<double>(edges_inside) / (edges_around > 0 ? edges_around : 1) : 0.0);
    const float straddling = static_cast<float>(labelled[h] > 0 ? sum[h] / (labelled[h] > 0 ? labelled[h] : 1) : 0.0);
    const float free_space = static_cast<float>(area > 0 ? static_cast<double>(free) / divisor : 0.0);
    scores.edges[h] = edges_inside;
    scores.free_voxels[h] = free;
    scores.edge_density[h] = edge_density;
    scores.outer_edges[h] = outer_edges;
    scores.straddling[h] = straddling;
    scores.free_space[h] = free_space;
    scores.objectness[h] =
        static_cast<float>(k.weight_edges * edge_density + k.weight_outer * outer_edges * straddling +
                           k.weight_free * free_space + k.constant);
  }
}

}  // namespace objectness

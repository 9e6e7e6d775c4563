// SPDX-License-Identifier: BSD-3-Clause
#include "search/bound_kernel.hpp"

#include "common/target_clones.hpp"
#include "search/lanes.hpp"

namespace objectness {
namespace {

constexpr float kImpossible = 2.0f;  // more than Eq. 4 can be

constexpr Floats kRamp = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr Sums kSumsRamp = {0, 1, 2, 3, 4, 5, 6, 7};

}  // namespace

OBJECTNESS_CLONES("avx2")
HeightRange neededStraddling(const NodeFootprint& node, const BoundConstants& constants, HeightRange heights,
                             float* straddling) {
  const BoundConstants k = constants;
  const Floats zero = {}, one = zero + 1.0f, tiny = zero + 1e-20f, impossible = zero + kImpossible;
  const Floats max_density = zero + k.max_edge_density, min_straddling = zero + k.min_straddling;
  for (int h = heights.first; h <= heights.last; h += kLanes) {
    Floats edges, ring_outer, ring_inner, free, top;
    countsAt(node.edges_outer, h, edges);
    countsAt(node.ring_outer, h, ring_outer);
    countsAt(node.ring_inner, h, ring_inner);
    const Floats ring = ring_outer - ring_inner;
    Sums filled;
    sumsAt(node.filled_inner, h, filled);
    // Modulo 2^16 it is never more than the free voxels that there are: still a bound.
    const Sums free_sums = node.inner_base * (kSumsRamp + static_cast<std::uint16_t>(h)) - filled;
    toFloats(free_sums, free);
    load(k.top_visible + h, top);
    const Floats height = kRamp + static_cast<float>(h);
    const Floats area_low = node.sides_low * height + node.base_low * top;
    const Floats area_high = node.sides_high * height + node.base_high * top;
    // Edge density and free space together, over all areas from low to high: the sum first rises with the area (as long
    // as the density is clipped), then falls if it is positive and rises if it is negative.
    const Floats sum = k.weight_edges * edges + k.weight_free * free;
    Floats area, density, at_least, divisor;
    smaller(edges * k.per_max_edge_density, area_high, area);
    larger(area, area_low, area);
    area = sum >= zero ? area : area_high;
    larger(area, one, area);
    const Floats per_area = one / area;
    smaller(edges * per_area, max_density, density);
    Floats both = k.weight_edges * density + k.weight_free * free * per_area;
    // A box of which no face is visible has neither cue.
    both = area_low > zero ? both : (both > zero ? both : zero);
    // (needed - both) / (weight_outer * edges / (edges + ring))
    larger(k.weight_outer * edges, tiny, divisor);
    larger((k.needed - both) * (edges + ring) / divisor, min_straddling, at_least);
    at_least = edges >= zero + k.min_edges ? at_least : impossible;
    store(at_least, straddling + h);
  }
  HeightRange left = heights;
  while (left.first <= left.last && !(straddling[left.first] <= 1.0f)) ++left.first;
  while (left.first <= left.last && !(straddling[left.last] <= 1.0f)) --left.last;
  return left;
}

OBJECTNESS_CLONES("avx2")
HeightRange possibleHeights(const CutSuperpixel* superpixels, int count, const float* counts, const float* squares,
                            float slack, HeightRange heights, const float* needed) {
  HeightRange left = {heights.last + 1, heights.first - 1};
  for (int group = heights.first; group <= heights.last; group += kLanes) {
    Floats whole_counts, whole_squares, need;
    load(counts + group, whole_counts);
    load(squares + group, whole_squares);
    load(needed + group, need);
    Floats sum = whole_squares - need * whole_counts;
    for (int s = 0; s < count; ++s) {
      Floats least, most, added;
      countsAt(superpixels[s].inner, group, least);
      countsAt(superpixels[s].outer, group, most);
      const float per_total = superpixels[s].per_total;
      larger(least * (least * per_total - need), most * (most * per_total - need), added);
      sum += added;
    }
    float margin[kLanes];
    store(sum, margin);
    for (int i = 0; i < kLanes && group + i <= heights.last; ++i) {
      if (!(needed[group + i] <= 1.0f && margin[i] >= -slack)) continue;
      if (left.first > heights.last) left.first = group + i;
      left.last = group + i;
    }
  }
  return left;
}

}  // namespace objectness

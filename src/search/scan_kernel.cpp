// SPDX-License-Identifier: BSD-3-Clause
#include "search/scan_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

inline float countAt(const CornerColumns& c, int h) {
  return static_cast<float>(static_cast<std::uint16_t>(c.p11[h] - c.p01[h] - c.p10[h] + c.p00[h]));
}

}  // namespace

OBJECTNESS_CLONES("avx2")
float boundHeights(const ScanFootprint& footprint, const ScanConstants& constants, int first, int last, float* bound) {
  const CornerColumns e = footprint.edges, r = footprint.ring, f = footprint.filled;
  const ScanConstants k = constants;
  const float base = footprint.base, sides = footprint.sides;
  const float* top_visible = footprint.top_visible;
  const float outer_gain = k.weight_outer * k.max_straddling_gain;
  float best = -1e30f;
  for (int h = first; h <= last; ++h) {
    const float edges = countAt(e, h);
    const float ring = countAt(r, h);
    const float filled = countAt(f, h);
    const float height = static_cast<float>(h);
    const float area = sides * height + base * top_visible[h];
    const float per_area = area > 0 ? 1.0f / area : 0.0f;
    const float density = edges * per_area < k.max_edge_density ? edges * per_area : k.max_edge_density;
    const float outer = edges / (ring > 1.0f ? ring : 1.0f);
    float value = k.weight_edges * density + outer_gain * outer + k.weight_free * (base * height - filled) * per_area +
                  k.constant;
    value = edges >= k.min_edges ? value : -1e30f;
    bound[h - first] = value;
    best = value > best ? value : best;
  }
  return best;
}

}  // namespace objectness

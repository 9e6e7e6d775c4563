// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/search/scan_kernel.hpp"

#include "objectness_segmentation/common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("avx2")
float boundHeights(const ScanFootprint& footprint, const ScanConstants& constants, int first, int last, float* bound) {
  const FootprintColumns e = footprint.edges, r = footprint.ring, f = footprint.filled;
  const ScanConstants k = constants;
  const float base = footprint.base, sides = footprint.sides;
  const float* top_visible = footprint.top_visible;
  const float outer_gain = k.weight_outer * k.max_straddling_gain;
  float best = -1e30f;
  for (int h = first; h <= last; ++h) {
    const float edges = static_cast<float>(e.p11[h] - e.p01[h] - e.p10[h] + e.p00[h]);
    const float ring = static_cast<float>(r.p11[h] - r.p01[h] - r.p10[h] + r.p00[h]);
    const float filled = static_cast<float>(f.p11[h] - f.p01[h] - f.p10[h] + f.p00[h]);
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

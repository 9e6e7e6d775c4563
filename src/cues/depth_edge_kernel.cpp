// SPDX-License-Identifier: BSD-3-Clause
#include "cues/depth_edge_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

/// Negated: NaN is unlike everything.
inline bool unlike(float a, float b, float min_step_m) {
  const float difference = a - b;
  return !((difference < 0 ? -difference : difference) <= min_step_m);
}

inline bool missing(float z) { return z != z; }

}  // namespace

OBJECTNESS_CLONES("avx2")
void markDepthChanges(const float* above, const float* z, const float* below, int width, float min_step_m,
                      unsigned char* bits) {
  for (int u = 0; u < width; ++u) {
    const unsigned char left = unlike(z[u], z[u - 1], min_step_m) ? kUnlikeLeft : 0;
    const unsigned char up = unlike(z[u], above[u], min_step_m) ? kUnlikeAbove : 0;
    const bool hole = missing(z[u - 1]) | missing(z[u + 1]) | missing(above[u]) | missing(below[u]);
    const unsigned char all = left | up | (hole ? kBesideHole : 0);
    bits[u] = missing(z[u]) ? 0 : all;
  }
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "scene/depth_discontinuity_kernel.hpp"

#include <cstring>

#include "common/target_clones.hpp"

namespace objectness {
namespace {

/// Negated, so that a NaN on either side counts as a jump.
inline bool apart(float a, float b, const DiscontinuityLimits& limits) {
  const float z = b < a ? b : a;
  const float noise = limits.constant + limits.quadratic * z * z, grazing = limits.slope * z;
  const float difference = a - b;
  return !((difference < 0 ? -difference : difference) <= (noise < grazing ? grazing : noise));
}

inline unsigned char smaller(unsigned char a, unsigned char b) { return a < b ? a : b; }

inline unsigned char farther(unsigned char distance, unsigned char steps) {
  return distance > 255 - steps ? 255 : static_cast<unsigned char>(distance + steps);
}

}  // namespace

OBJECTNESS_CLONES("avx2")
void findDiscontinuitiesInRow(const float* z, const float* below, int width, const DiscontinuityLimits& limits,
                              unsigned char* jump) {
  const DiscontinuityLimits l = limits;
  for (int u = 0; u + 1 < width; ++u) jump[u] = apart(z[u], z[u + 1], l) ? 1 : 0;
  jump[width - 1] = 0;
  if (!below) return;
  for (int u = 0; u < width; ++u) jump[u] |= apart(z[u], below[u], l) ? 2 : 0;
}

OBJECTNESS_CLONES("avx2")
void findClearInRow(const ClearRow& above, const ClearRow& row, const ClearRow& below, int width,
                    unsigned char* clear) {
  const unsigned char *valid_a = above.valid, *valid_r = row.valid, *valid_b = below.valid;
  const unsigned char *jump_a = above.jump, *jump_r = row.jump, *jump_b = below.jump;
  clear[0] = clear[width - 1] = 0;
  for (int u = 1; u + 1 < width; ++u) {
    const unsigned char valid = valid_a[u - 1] & valid_a[u] & valid_a[u + 1] & valid_r[u - 1] & valid_r[u] &
                                valid_r[u + 1] & valid_b[u - 1] & valid_b[u] & valid_b[u + 1];
    // Bit 0: apart to the side, bit 1: apart downwards. Diagonal neighbours are apart when both ways around are cut;
    // the way that begins with a jump at the pixel itself is cut already.
    const unsigned char beside = jump_r[u] | jump_r[u - 1], over = jump_r[u] | jump_a[u];
    const unsigned char to_lower_right = jump_b[u] & (jump_r[u + 1] >> 1);
    const unsigned char to_lower_left = jump_b[u - 1] & (jump_r[u - 1] >> 1);
    const unsigned char to_upper_right = jump_a[u] & (jump_a[u + 1] >> 1);
    const unsigned char to_upper_left = jump_a[u - 1] & (jump_a[u - 1] >> 1);
    const unsigned char apart =
        (beside | (over >> 1) | to_lower_right | to_lower_left | to_upper_right | to_upper_left) & 1;
    clear[u] = apart ? 0 : valid;
  }
}

OBJECTNESS_CLONES("avx2")
void spreadDistance(const unsigned char* before, int width, int most, unsigned char* distance, unsigned char* scratch) {
  if (before) {
    for (int u = 0; u < width; ++u) {
      const unsigned char nearest = smaller(smaller(before[u - 1], before[u + 1]), before[u]);
      distance[u] = smaller(distance[u], farther(nearest, 1));
    }
  }
  for (int steps = 1; steps <= most; steps *= 2) {
    const unsigned char by = static_cast<unsigned char>(steps);
    for (int u = 0; u < width; ++u) {
      scratch[u] = smaller(distance[u], farther(smaller(distance[u - steps], distance[u + steps]), by));
    }
    std::memcpy(distance, scratch, static_cast<std::size_t>(width));
  }
}

}  // namespace objectness

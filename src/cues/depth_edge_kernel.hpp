// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Bits of what depth edges are looked for at.
constexpr unsigned char kUnlikeLeft = 1;   ///< the neighbour is missing or farther away in depth than min_step_m
constexpr unsigned char kUnlikeAbove = 2;  ///< the same
constexpr unsigned char kBesideHole = 4;   ///< one of the four neighbours is missing

/// Bits of a row of depths, 0 where the depth itself is missing. Missing is NaN, as all rows are from -1 to `width`
/// where there is no image.
void markDepthChanges(const float* above, const float* z, const float* below, int width, float min_step_m,
                      unsigned char* bits);

}  // namespace objectness

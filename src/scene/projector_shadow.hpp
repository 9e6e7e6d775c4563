// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Width in pixels, at most, of the strip without depth between what is near and what is behind it, along the line from
/// a camera to its projector or second camera: what one of the two does not see, and what the matching window spoils.
/// focal: pixels; depths: metres.
inline double widestShadowPx(double focal, double near_m, double behind_m) {
  constexpr double kMaxBaselineM = 0.1;
  constexpr double kSpillPx = 3;
  return focal * kMaxBaselineM * (1.0 / near_m - 1.0 / behind_m) + kSpillPx;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Bounds of every image that is read or made: more than any depth camera has, and its indices fit an int.
constexpr int kMaxSidePx = 16384;
constexpr int kMaxPixels = 1 << 24;

}  // namespace objectness

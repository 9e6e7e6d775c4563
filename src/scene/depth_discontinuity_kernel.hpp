// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// What neighbouring depths may differ by: the larger of constant + quadratic z^2 and slope z, with z the nearer one.
struct DiscontinuityLimits {
  float constant, quadratic, slope;
};

/// Which depths of a row are apart from their right neighbour (bit 0) and from the one below (bit 1). below: nullptr in
/// the last row. NaN is apart from everything.
void findDiscontinuitiesInRow(const float* z, const float* below, int width, const DiscontinuityLimits& limits,
                              unsigned char* jump);

/// A row of pixels with what decides whether a window may hold them; a row outside the image is all invalid.
struct ClearRow {
  const unsigned char* valid;  ///< 255 or 0
  const unsigned char* jump;   ///< bits as of findDiscontinuitiesInRow()
};

/// 255 where a pixel and its 8 neighbours are valid and no jump parts it from any of them, else 0.
void findClearInRow(const ClearRow& above, const ClearRow& row, const ClearRow& below, int width, unsigned char* clear);

/// One step of a distance transform in the chessboard metric, both ways along a row: makes `distance` no larger than
/// that of any pixel of the row, or of `before` (the row done before; may be nullptr), plus the steps to it, as far as
/// this is not above `most`. Both have kDistanceMargin bytes of 255 to either side; `scratch` is like them.
void spreadDistance(const unsigned char* before, int width, int most, unsigned char* distance, unsigned char* scratch);
constexpr int kDistanceMargin = 128;

}  // namespace objectness

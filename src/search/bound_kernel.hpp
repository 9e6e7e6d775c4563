// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace objectness {

/// The columns of an integral volume at the four corners of a footprint, indexed by height. Sums are modulo 2^16.
struct CornerColumns {
  const std::uint16_t *p11, *p01, *p10, *p00;
};

/// What is known of all boxes of a node (BoundedSearch): `outer` holds each of them, each of them holds `inner`.
struct NodeFootprint {
  CornerColumns edges_outer;    ///< of the edge volume
  CornerColumns ring_outer;     ///< edge volume over the expanded inner box, raised by the ring's height
  CornerColumns ring_inner;     ///< edge volume over what that shares with the outer box
  CornerColumns filled_inner;   ///< of the filled volume
  std::uint16_t inner_base;     ///< voxels of the inner footprint
  float base_low, base_high;    ///< least and largest top face
  float sides_low, sides_high;  ///< least and largest visible side area per voxel of height
};

/// Eq. 6 as the bound needs it; weight_edges, weight_outer >= 0, weight_free <= 0.
struct BoundConstants {
  float weight_edges, weight_outer, weight_free;
  float needed;  ///< threshold minus constant, minus what rounding may cost
  float max_edge_density, per_max_edge_density, min_edges, min_straddling;
  const float* top_visible;  ///< per height: 1 where the top face is visible
};

/// Heights first..last, both ends included; none when first > last.
struct HeightRange {
  int first, last;
};

/// For the heights in `heights`: the superpixel cue (Eq. 4) that a box of the node needs to reach the threshold, in
/// straddling[h]; over 1 where none can reach it. Returns the least range with all heights where one can. Reads and
/// writes up to seven heights over the last (IntegralVolume::kPadding).
HeightRange neededStraddling(const NodeFootprint& node, const BoundConstants& constants, HeightRange heights,
                             float* straddling);

/// A superpixel that some boxes of a node may cut.
struct CutSuperpixel {
  CornerColumns outer, inner;
  float per_total;  ///< 1 / its voxels
};

/// Of the heights in `heights`, the least range with all at which Eq. 4 can reach needed[h]. With k of the n voxels of
/// each superpixel in a box, it does where the sum over all superpixels of k (k / n - needed) is not negative. The term
/// is convex in k, so its maximum is at the least or the largest k. counts, squares: per height the sum of k and of
/// k^2 / n over the superpixels that are in all boxes of the node; slack: what rounding may cost the sum.
HeightRange possibleHeights(const CutSuperpixel* superpixels, int count, const float* counts, const float* squares,
                            float slack, HeightRange heights, const float* needed);

}  // namespace objectness

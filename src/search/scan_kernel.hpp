// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/bound_kernel.hpp"

namespace objectness {

/// The weights of Eq. 6 and the gate as the kernel needs them.
struct ScanConstants {
  float weight_edges, weight_outer, weight_free, constant;
  float max_edge_density;
  float max_straddling_gain;  ///< factor of weight_outer that no straddling cue exceeds: 1, or 0 for a negative weight
  float min_edges;
};

/// The footprint of a row of boxes that differ in height only; lengths and areas in voxels.
struct ScanFootprint {
  CornerColumns edges, ring, filled;  ///< ring: of the expanded footprint, already shifted up by the ring's height
  float base;                         ///< sx * sy
  float sides;                        ///< visible side area per voxel of height
  const float* top_visible;           ///< 1 where the top face at this height is visible, else 0
};

/// bound[h - first] >= objectness of the box of height h, h = first..last, up to float rounding; -1e30 where the edge
/// gate rejects it. Returns the largest bound. Plain types only: compiled for several instruction sets, chosen at run
/// time.
float boundHeights(const ScanFootprint& footprint, const ScanConstants& constants, int first, int last, float* bound);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/bound_kernel.hpp"

namespace objectness {

/// All boxes over one footprint, counted in pieces of at most IntegralVolume::kMostCounted voxels.
struct BoxColumns {
  CornerColumns edges, ring;  ///< ring: of the expanded footprint, raised by the ring's height
  CornerColumns filled, occupied;
  double size_x, size_y;                ///< voxels
  bool side_x_visible, side_y_visible;  ///< the visible sides: sy * height and sx * height
};

struct SuperpixelColumns {
  CornerColumns columns;
  int total;
};

/// Eq. 6 with everything it needs, as scoreBox() uses it.
struct ScoreConstants {
  double weight_edges, weight_outer, weight_free, constant, max_edge_density;
  const float* top_visible;  ///< per height: 1 where the top face is visible
};

/// What scoreBox() computes, indexed by height.
struct ScoreColumns {
  int *edges, *occupied, *free_voxels;
  float *edge_density, *outer_edges, *straddling, *free_space, *objectness;
  double* sum;    ///< scratch
  int* labelled;  ///< scratch
};

/// scoreBox() of the heights in `heights` without its gates, to the last bit: the same arithmetic in the same order.
/// occupied is filled for all heights from 0. superpixels: those the footprint meets, in their order.
void scoreHeights(const BoxColumns& box, const SuperpixelColumns* superpixels, int count,
                  const ScoreConstants& constants, HeightRange heights, const ScoreColumns& scores);

}  // namespace objectness

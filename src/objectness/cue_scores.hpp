// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

// The cues of paper Sec. 3 as pure functions of counts. Unit: everything is counted in voxels, areas in squares of a
// voxel's side (cm^2 at the paper's 1 cm), so that the weights of Eq. 6 mean the same at any distance from the camera.

/// a(b), the visible area: the faces of the box whose outer side the viewpoint (grid coordinates) sees, at most three.
double visibleArea(const Box& box, const Eigen::Vector3d& viewpoint);

/// The alternative a(b) = sx sy + sx sz + sy sz, whatever the viewpoint.
double threeFaceArea(const Box& box);

/// Eq. 1: delta_i(b) = |edges in b| / a(b). 0 when no face is visible.
double edgeDensity(int edges, double area);

/// Eq. 2: delta_o(b) = |edges in b| / |edges in b_eps|: 1 when the surroundings hold no edges. 0 when b_eps holds none.
double outerEdges(int edges, int edges_expanded);

/// Eq. 3: delta_l(b, s) = |p(b and s)|^2 / |p(s)|.
double straddling(int inside, int total);

/// Eq. 4: delta_l(b) = sum over s of delta_l(b, s) / |p(b)|, |p(b)| = voxels of any superpixel in b. 0 when there are
/// none.
double straddling(double sum_over_superpixels, int labelled);

/// Eq. 5: delta_f(b) = (V(b) - |p(b)| - |p_VO(b)|) / a(b); filled = occupied and occluded voxels. 0 when no face is
/// visible.
double freeSpace(long volume, int filled, double area);

}  // namespace objectness

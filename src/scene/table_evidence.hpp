// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/plane_grid.hpp"

namespace objectness {

/// What speaks for a plane being the table.
struct TableEvidence {
  double area_m2 = 0;     ///< of its extent
  double distance_m = 0;  ///< median depth of its samples
  int carried = 0;        ///< samples of things that stand on it, scaled to 40 000 samples a view
  double below = 0;       ///< samples under it within its extent, per sample on it
  double seen_m2 = 0;     ///< the part of it that is seen rather than bridged
  double hidden_m2 = 0;   ///< next to what is seen of it, and nothing tells whether it goes on there
  double inliers = 0;     ///< samples on it, scaled to 40 000 samples a view

  /// Larger is more table-like; for comparing planes of one view. hidden_counts: what is hidden counts as if it was
  /// seen; this would make tables of the fronts and tops of boxes, unless other things speak against that.
  double score(const Plane& plane, bool hidden_counts = false) const;
};

/// A plane in a view and its evidence. Terms of `evidence` that are not computed yet hold their maximum, so its score
/// is an upper bound.
struct SeenPlane {
  PlaneGrid grid;
  cv::Mat_<uchar> core;  ///< 255 = table that was seen, and what it surrounds; of the size of the grid
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< of the core, camera frame
  TableEvidence evidence;
};
SeenPlane seePlane(const SurfaceSamples& samples, const Plane& plane);

/// Whether `plane` lies under the other one, on which a place is known, as a floor lies under a table.
bool liesUnder(const Plane& plane, const Plane& other, const Eigen::Vector3d& place_on_other);

/// All of the evidence. `focal` is that of the view's camera, pixels.
TableEvidence judgeTable(const SurfaceSamples& samples, const Plane& plane, const SeenPlane& seen, double focal);

}  // namespace objectness

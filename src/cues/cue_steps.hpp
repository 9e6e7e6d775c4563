// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cues/crease.hpp"
#include "cues/smooth_surface.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"

namespace objectness {

/// Where edges of the objects can lie, and the wider surroundings that tell them from what only ends there. 255 = yes.
struct EdgeRegion {
  cv::Mat_<uchar> near, around;
  cv::Rect box;  ///< around `near`
};
EdgeRegion edgeRegion(const Normals& normals, const ObjectPoints& object_points);

/// findEdges(), the bends given: at least those of region.around.
EdgeMap findEdges(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
                  const EdgeRegion& region, const BendMap& bends, const EdgesConfig& config, int threads);

/// Object points whose window is one smooth piece of surface: not fitted badly, not bent, no step. 255 = smooth.
/// bends: at least those of object_points.mask.
cv::Mat_<uchar> smoothPixels(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                             const BendMap& bends, const SuperpixelsConfig& config, int threads);

/// findSuperpixels() from the smooth surface on.
Superpixels growSuperpixels(const Frame& frame, const SmoothSurface& surface, const SuperpixelsConfig& config);

}  // namespace objectness

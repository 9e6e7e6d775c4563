// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"

namespace objectness {

/// Paper Sec. 3.1 and 3.3.
struct SurfaceCues {
  EdgeMap edges;
  Superpixels superpixels;
};

/// What findEdges() and findSuperpixels() find, in less time: both look at how the surface bends, which is found once
/// for both, and what either does pixel after pixel is done at the same time.
SurfaceCues findSurfaceCues(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const EdgesConfig& edges,
                            const SuperpixelsConfig& superpixels, int threads = 1);

}  // namespace objectness

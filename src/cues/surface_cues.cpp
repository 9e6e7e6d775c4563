// SPDX-License-Identifier: BSD-3-Clause
#include "cues/surface_cues.hpp"

#include "common/parallel.hpp"
#include "cues/cue_steps.hpp"

namespace objectness {

SurfaceCues findSurfaceCues(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const EdgesConfig& edges,
                            const SuperpixelsConfig& superpixels, int threads) {
  SurfaceCues cues;
  const EdgeRegion region = edgeRegion(normals, object_points);
  const BendMap bends = findBends(frame, normals, region.around, threads);
  const cv::Mat_<uchar> smooth = smoothPixels(frame, normals, object_points, bends, superpixels, threads);
  const SmoothSurface surface = connectSmooth(frame, normals, table.noise, smooth, superpixels, threads);
  inParallel(
      threads, [&] { cues.edges = findEdges(frame, normals, table, object_points, region, bends, edges, threads); },
      [&] { cues.superpixels = growSuperpixels(frame, surface, superpixels); });
  return cues;
}

}  // namespace objectness

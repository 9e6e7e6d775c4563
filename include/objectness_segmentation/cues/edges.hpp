// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// The four kinds of edges of paper Sec. 3.1, as bits of EdgeMap::kinds.
enum EdgeKind : unsigned char {
  kHighCurvature = 1,  ///< crease of the surface
  kOccluding = 2,      ///< near side of a depth jump
  kOccluded = 4,       ///< far side of a depth jump
  kBorder = 8          ///< valid pixel beside missing depth or the image border
};

struct EdgeMap {
  cv::Mat_<uchar> kinds;  ///< H x W, EdgeKind bits of the pixels that survived the clean-up near the table, 0 = no edge
};

struct EdgesConfig {
  bool pcl = false;
  double step_m = 0.01;
  double step_sigmas = 4.0;
  double gap_m = 0.05;
  double crease_deg = 35.0;
  double min_length_m = 0.01;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("pcl", self.pcl, "use pcl::OrganizedEdgeFromNormals, not the metric detector; only min_length_m counts");
    visit("step_m", self.step_m, Range{0.001, 1}, "depth edge: neighbours differ in depth by more than this");
    visit("step_sigmas", self.step_sigmas, Range{0, 100}, "and by more than this many sigma_z");
    visit("gap_m", self.gap_m, Range{0, 1}, "how far the other side of missing depth is searched; none: a border");
    visit("crease_deg", self.crease_deg, Range{5, 175},
          "crease: least angle between the normals one window radius to either side");
    visit("min_length_m", self.min_length_m, Range{0, 0.2}, "connected edges that span less than this are noise");
  }
};

/// Edges of the objects: of pixels of object_points.mask, and creases where an object meets the table, which lie up to
/// one normal window outside it. Depth steps and creases are metric: they read the same at any resolution and depth.
EdgeMap findEdges(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
                  const EdgesConfig& config, int threads = 1);

}  // namespace objectness

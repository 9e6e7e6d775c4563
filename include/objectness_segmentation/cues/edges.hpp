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
  cv::Mat_<uchar> kinds;  ///< H x W, EdgeKind bits of every pixel that survived the clean-up near the table, 0 = no edge
};

struct EdgesConfig {
  bool pcl = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("pcl", self.pcl, "use pcl::OrganizedEdgeFromNormals instead of the metric detector");
  }
};

EdgeMap findEdges(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
                  const EdgesConfig& config);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "objectness_segmentation/grouping/borders.hpp"

namespace objectness {

/// What lies between two pieces that do not touch: could they be parts of one thing behind an occluder? Shares are of
/// the samples along segments between the nearest points of their outlines, as the depth image sees them.
struct GapCues {
  float occluded_share = 0;  ///< behind a nearer surface: anything may be there
  float best_occluded = 0;   ///< of the segment that is hidden most
  float free_share = 0;      ///< the camera sees through, or the bare table: certainly nothing there
  float most_free = 0;       ///< of the segment that is seen through most
  float surface_share = 0;   ///< on a measured surface
  float cosine = 0;          ///< between the mean normals
  float plane_offset = 0;    ///< larger distance of either centroid from the other's plane, by their distance
  float flush = 0;           ///< the same of the nearest points, in units of the noise
  float distance = 0;        ///< between the nearest points, by the square root of the smaller area
  float size_ratio = 0;      ///< area of the smaller piece by that of the larger one

  template <class Self, class Visit>
  static void cues(Self& self, Visit&& visit) {
    visit("occluded_share", self.occluded_share);
    visit("best_occluded", self.best_occluded);
    visit("free_share", self.free_share);
    visit("most_free", self.most_free);
    visit("surface_share", self.surface_share);
    visit("cosine", self.cosine);
    visit("plane_offset", self.plane_offset);
    visit("flush", self.flush);
    visit("distance", self.distance);
    visit("size_ratio", self.size_ratio);
  }
};

/// Points of each piece's outline, at most so many of each, evenly along its pixels.
std::vector<std::vector<int>> outlinePixels(const Pieces& pieces, int most, int threads = 1);

/// None when the pieces are farther apart than max_distance_m.
std::optional<GapCues> findGapCues(const Frame& frame, const Table& table, const ObjectPoints& object_points,
                                   const Pieces& pieces, const std::vector<std::vector<int>>& outlines, int first,
                                   int second, double max_distance_m);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/grouping/borders.hpp"

namespace objectness {

/// What the common border of two pieces in contact says. Angles are signed, degrees: positive where the surface bends
/// away from itself (convex: an edge of one thing), negative where it bends towards itself (concave: things that
/// touch).
struct ContactCues {
  float angle_median_deg = 0;
  float angle_low_deg = 0, angle_high_deg = 0;  ///< 20 and 80 percentile
  float concave_share = 0, convex_share = 0;    ///< of the samples: under -10, over +10 degrees
  float contact_share = 0;                      ///< of the common border, the rest are depth jumps
  float contact_of_outline = 0;                 ///< contact length by the outline of the piece with the shorter one
  float upper_upright = 0, lower_upright = 0;  ///< normal . table normal of the side that lies higher, and of the other
  float step = 0;        ///< RMS distance between the planes of either side at the border, in units of the noise
  float size_ratio = 0;  ///< area of the smaller piece by that of the larger one

  template <class Self, class Visit>
  static void cues(Self& self, Visit&& visit) {
    visit("angle_median_deg", self.angle_median_deg);
    visit("angle_low_deg", self.angle_low_deg);
    visit("angle_high_deg", self.angle_high_deg);
    visit("concave_share", self.concave_share);
    visit("convex_share", self.convex_share);
    visit("contact_share", self.contact_share);
    visit("contact_of_outline", self.contact_of_outline);
    visit("upper_upright", self.upper_upright);
    visit("lower_upright", self.lower_upright);
    visit("step", self.step);
    visit("size_ratio", self.size_ratio);
  }
};

/// Cues of two pieces in contact: border.samples is not empty. Each side of a sample is seen as the mean of the smooth
/// points of its piece that lie nearest.
ContactCues findContactCues(const Frame& frame, const Normals& normals, const Table& table,
                            const Superpixels& superpixels, const Pieces& pieces, const Borders& borders, int first,
                            int second);

}  // namespace objectness

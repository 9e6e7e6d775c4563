// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

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

/// What speaks for a group of pieces being one whole object. No cue has a unit: large and small objects count alike.
struct GroupCues {
  // The graph of links.
  float mean_logit = 0;       ///< log odds of the links inside
  float logit_per_piece = 0;  ///< their sum by the number of pieces
  float weakest_piece = 1;    ///< probability of the strongest link of the piece that is linked worst
  float bottleneck = 1;       ///< of the weakest link of the maximum spanning tree
  float best_outside = 0;     ///< of the strongest link to a piece outside
  float outside_logit = 0;    ///< sum of the positive log odds of links to the outside, by the number of pieces
  float pieces = 0;
  // The outline, as shares of its length: what it lies against.
  float table = 0, front = 0, behind = 0, unknown = 0, image_border = 0;  ///< see Outline
  float contact = 0;                                                      ///< it touches other pieces
  float hidden = 0, hides = 0;  ///< other pieces are in front of it, or behind it
  float concave_outside = 0, convex_outside = 0, concave_inside = 0, convex_inside = 0;  ///< lengths of contact
  // The tight box.
  float face_share = 0;                ///< of its points near the box's visible faces
  float box_fill = 0;                  ///< surface seen by the silhouette of the box
  float other_points = 0;              ///< share of the points in the box that are not its own
  float upright = 1;                   ///< |cosine| between the box's z axis and the table's normal
  float elongation = 0, flatness = 0;  ///< middle by longest, shortest by middle side
  float base_height = 0;               ///< of its lowest point by that of its highest
  float free = 0, behind_own = 0, behind_other = 0, unseen = 0;  ///< shares of the box's volume as the camera sees it
  float hull_fill = 0;                                           ///< pixels by the area of their convex hull
  // The paper's cues of the tight box.
  float edge_density = 0;  ///< delta_i, Eq. 1: length of edges by the root of the visible area, which has no unit
  float outer_edges = 0;   ///< delta_o, Eq. 2
  float straddling = 0;    ///< delta_l, Eq. 4

  template <class Self, class Visit>
  static void cues(Self& self, Visit&& visit) {
    visit("mean_logit", self.mean_logit);
    visit("logit_per_piece", self.logit_per_piece);
    visit("weakest_piece", self.weakest_piece);
    visit("bottleneck", self.bottleneck);
    visit("best_outside", self.best_outside);
    visit("outside_logit", self.outside_logit);
    visit("pieces", self.pieces);
    visit("table", self.table);
    visit("front", self.front);
    visit("behind", self.behind);
    visit("unknown", self.unknown);
    visit("image_border", self.image_border);
    visit("contact", self.contact);
    visit("hidden", self.hidden);
    visit("hides", self.hides);
    visit("concave_outside", self.concave_outside);
    visit("convex_outside", self.convex_outside);
    visit("concave_inside", self.concave_inside);
    visit("convex_inside", self.convex_inside);
    visit("face_share", self.face_share);
    visit("box_fill", self.box_fill);
    visit("other_points", self.other_points);
    visit("upright", self.upright);
    visit("elongation", self.elongation);
    visit("flatness", self.flatness);
    visit("base_height", self.base_height);
    visit("free", self.free);
    visit("behind_own", self.behind_own);
    visit("behind_other", self.behind_other);
    visit("unseen", self.unseen);
    visit("hull_fill", self.hull_fill);
    visit("edge_density", self.edge_density);
    visit("outer_edges", self.outer_edges);
    visit("straddling", self.straddling);
  }
};

}  // namespace objectness

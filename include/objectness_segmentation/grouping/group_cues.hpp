// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/grouping/links.hpp"
#include "objectness_segmentation/objectness/box.hpp"

namespace objectness {

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

/// A group with its tight box and its cues.
struct GroupHypothesis {
  std::vector<int> pieces;  ///< ascending
  OrientedBox box;          ///< camera's optical frame
  GroupCues cues;
  float objectness = 0;  ///< 0..1: expected overlap with a true object (judgeGroups()), or judgeGroupsByHand()
  float remembered = 0;  ///< 1: it is an object of the frame before; -1: it was none; 0: not known
};

/// What groups are judged by; must outlive the scorer.
struct GroupEvidence {
  const Frame& frame;
  const Table& table;
  const EdgeMap& edges;
  const Pieces& pieces;
  const Borders& borders;
  const std::vector<Link>& links;
};

/// Boxes and cues of the groups, in their order; does not depend on the number of threads.
std::vector<GroupHypothesis> describeGroups(const GroupEvidence& evidence, const std::vector<std::vector<int>>& groups,
                                            int threads);

}  // namespace objectness

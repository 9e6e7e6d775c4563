// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/grouping/borders.hpp"
#include "objectness_segmentation/grouping/contact_cues.hpp"
#include "objectness_segmentation/grouping/cue_switches.hpp"
#include "objectness_segmentation/grouping/gap_cues.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"

namespace objectness {

/// How probably two pieces are parts of one object, and why.
struct Link {
  int first, second;  ///< pieces, first < second
  bool contact;       ///< they touch; otherwise there is a gap between them
  float probability;
  float angle_deg = 0;         ///< of a contact, signed as in ContactCues
  float contact_length_m = 0;  ///< of a contact
};

/// The evidence about two pieces before it is judged: what a model learns from.
struct PairEvidence {
  int first, second;
  std::variant<ContactCues, GapCues> cues;
};

struct LinksConfig {
  double max_gap_m = 0.25;
  bool gaps = true;
  CueSwitches<ContactCues> contact_cues;  // their fields are groups of their own: see Config
  CueSwitches<GapCues> gap_cues;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("max_gap_m", self.max_gap_m, Range{0, 1}, "pieces farther apart are not parts of one object");
    visit("gaps", self.gaps,
          "pieces that do not touch can be linked over the gap; off: nothing is known of such pairs");
  }
};

/// Contact cues of all pairs that touch, gap cues of all others near enough (none with config.gaps off); ordered by
/// (first, second). Cues that are switched off are neutral.
std::vector<PairEvidence> findPairEvidence(const Frame& frame, const Normals& normals, const Table& table,
                                           const ObjectPoints& object_points, const Superpixels& superpixels,
                                           const Pieces& pieces, const Borders& borders, const LinksConfig& config,
                                           int threads = 1);

/// What a model makes of the evidence.
std::vector<Link> judgePairs(const std::vector<PairEvidence>& evidence, const Borders& borders,
                             const LearnedObjectness& model, int threads = 1);

}  // namespace objectness

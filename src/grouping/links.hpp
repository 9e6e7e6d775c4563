// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "grouping/borders.hpp"
#include "grouping/contact_cues.hpp"
#include "grouping/gap_cues.hpp"
#include "objectness_segmentation/grouping/cue_switches.hpp"
#include "objectness_segmentation/grouping/grouping_config.hpp"
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

/// Contact cues of all pairs that touch, gap cues of all others near enough (none with config.gaps off); ordered by
/// (first, second). Cues that are switched off are neutral.
std::vector<PairEvidence> findPairEvidence(const Frame& frame, const Normals& normals, const Table& table,
                                           const ObjectPoints& object_points, const Superpixels& superpixels,
                                           const Pieces& pieces, const Borders& borders, const LinksConfig& config,
                                           int threads = 1);

/// What a model makes of the evidence.
std::vector<Link> judgePairs(const std::vector<PairEvidence>& evidence, const Borders& borders,
                             const LearnedObjectness& model, int threads = 1);

/// ln(p / (1 - p)), with p kept off certainty.
float logOdds(float probability);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/link_cues.hpp"

#include <algorithm>
#include <cmath>

#include "common/disjoint_sets.hpp"

namespace objectness {
namespace {

/// Probability of the weakest link of the maximum spanning tree over the group, 0 when its links do not connect it.
float bottleneck(std::vector<const Link*> links, std::size_t pieces, std::size_t all_pieces) {
  std::sort(links.begin(), links.end(), [](const Link* a, const Link* b) {
    return a->probability != b->probability ? a->probability > b->probability : a < b;
  });
  DisjointSets sets(static_cast<int>(all_pieces));
  std::size_t joined = 1;
  for (const Link* link : links) {
    if (sets.root(link->first) == sets.root(link->second)) continue;
    sets.join(link->first, link->second);
    if (++joined == pieces) return link->probability;
  }
  return pieces == 1 ? 1 : 0;
}

}  // namespace

void addLinkCues(const GroupEvidence& evidence, const Members& group, GroupCues& cues) {
  std::vector<const Link*> within;
  std::vector<float> strongest(group.inside.size(), 0.f);
  float sum = 0, outside = 0;
  for (const Link& link : evidence.links) {
    const bool first = group.inside[link.first], second = group.inside[link.second];
    if (first && second) {
      within.push_back(&link);
      sum += logOdds(link.probability);
      strongest[link.first] = std::max(strongest[link.first], link.probability);
      strongest[link.second] = std::max(strongest[link.second], link.probability);
    } else if (first || second) {
      cues.best_outside = std::max(cues.best_outside, link.probability);
      outside += std::max(0.f, logOdds(link.probability));
    }
  }
  const float count = static_cast<float>(group.list.size());
  cues.pieces = count;
  cues.mean_logit = within.empty() ? 0 : sum / static_cast<float>(within.size());
  cues.logit_per_piece = sum / count;
  cues.outside_logit = outside / count;
  if (group.list.size() > 1) {
    for (const int piece : group.list) cues.weakest_piece = std::min(cues.weakest_piece, strongest[piece]);
  }
  cues.bottleneck = bottleneck(std::move(within), group.list.size(), group.inside.size());
}

void addOutlineCues(const GroupEvidence& evidence, const Members& group, GroupCues& cues) {
  Outline sum;
  for (const int piece : group.list) {
    const Outline& outline = evidence.borders.outlines[piece];
    sum.table += outline.table;
    sum.front += outline.front;
    sum.behind += outline.behind;
    sum.unknown += outline.unknown;
    sum.outside += outline.outside;
  }
  float contact = 0, hidden = 0, hides = 0;
  for (const auto& [key, pair] : evidence.borders.pairs) {
    const bool first = group.inside[key.first], second = group.inside[key.second];
    if (first == second) continue;
    contact += pair.contact;
    hidden += first ? pair.second_in_front : pair.first_in_front;
    hides += first ? pair.first_in_front : pair.second_in_front;
  }
  const float length =
      std::max(1e-6f, sum.table + sum.front + sum.behind + sum.unknown + sum.outside + contact + hidden + hides);
  cues.table = sum.table / length;
  cues.front = sum.front / length;
  cues.behind = sum.behind / length;
  cues.unknown = sum.unknown / length;
  cues.image_border = sum.outside / length;
  cues.contact = contact / length;
  cues.hidden = hidden / length;
  cues.hides = hides / length;

  constexpr float kConcave_deg = -20, kConvex_deg = 10;
  for (const Link& link : evidence.links) {
    const bool first = group.inside[link.first], second = group.inside[link.second];
    if (!link.contact || (!first && !second)) continue;
    const float share = link.contact_length_m / length;
    const bool both = first && second;
    if (link.angle_deg < kConcave_deg) (both ? cues.concave_inside : cues.concave_outside) += share;
    if (link.angle_deg > kConvex_deg) (both ? cues.convex_inside : cues.convex_outside) += share;
  }
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/group_selection.hpp"

#include <algorithm>

#include "grouping/links.hpp"

namespace objectness {
namespace {

constexpr double kRounding = 1e-9;  // of values and bounds that are summed up in different orders

}  // namespace

PackingProblem packingProblem(int pieces, const std::vector<Link>& links, const std::vector<GroupHypothesis>& groups,
                              const GroupingConfig& config) {
  std::vector<std::vector<std::pair<int, double>>> linked(pieces);  // by the first piece of each link
  for (const Link& link : links) {
    linked[link.first].emplace_back(link.second, (link.contact ? 1 : config.weight_gaps) * logOdds(link.probability));
  }
  PackingProblem problem;
  problem.elements = pieces;
  for (const GroupHypothesis& group : groups) {
    const double objectness = group.objectness + config.memory_objectness * group.remembered;
    double value = config.weight_objectness * (objectness - config.least_objectness) * group.pieces.size();
    for (const int first : group.pieces) {
      for (const auto& [second, odds] : linked[first]) {
        if (std::binary_search(group.pieces.begin(), group.pieces.end(), second)) value += odds;
      }
    }
    problem.sets.push_back(group.pieces);
    problem.values.push_back(value);
  }
  return problem;
}

Packing selectGroups(const PackingProblem& problem, const GroupingConfig& config, unsigned seed) {
  const Packing exact = packExactly(problem, config.exact_nodes);
  if (exact.optimal) return exact;
  const Packing annealed = packByAnnealing(problem, config.iterations, seed);
  Packing best = annealed.value > exact.value ? annealed : exact;
  best.bound = std::min(annealed.bound, exact.bound);
  best.optimal = best.value >= best.bound - kRounding;
  return best;
}

std::vector<Segment> cutGroups(const Pieces& pieces, const std::vector<GroupHypothesis>& groups,
                               const std::vector<int>& chosen, const SegmentsConfig& config) {
  std::vector<int> best_first = chosen;
  std::stable_sort(best_first.begin(), best_first.end(),
                   [&](int a, int b) { return groups[a].objectness > groups[b].objectness; });
  std::vector<Segment> segments;
  std::vector<char> taken(pieces.pieces.size(), 0);
  for (const int k : best_first) {
    const GroupHypothesis& group = groups[k];
    Segment segment;
    segment.box = group.box;
    segment.objectness = group.objectness;
    segment.cues = {group.cues.edge_density, group.cues.outer_edges, group.cues.straddling, group.cues.free, 0};
    for (const int piece : group.pieces) {
      if (taken[piece]) continue;
      taken[piece] = 1;
      const std::vector<int>& pixels = pieces.pieces[piece].pixels;
      const std::size_t before = segment.pixels.size();
      segment.pixels.insert(segment.pixels.end(), pixels.begin(), pixels.end());
      std::inplace_merge(segment.pixels.begin(), segment.pixels.begin() + before, segment.pixels.end());
    }
    if (static_cast<int>(segment.pixels.size()) >= config.min_pixels) segments.push_back(std::move(segment));
  }
  return segments;
}

}  // namespace objectness

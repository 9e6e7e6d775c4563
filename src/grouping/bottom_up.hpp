// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/group_selection.hpp"

namespace objectness {

/// The pieces of a frame and what is known of each pair of them.
struct PieceGraph {
  Pieces pieces;
  Borders borders;
  std::vector<PairEvidence> pairs;
};

PieceGraph findPieceGraph(const Frame& frame, const Normals& normals, const Table& table,
                          const ObjectPoints& object_points, const Superpixels& superpixels, const PiecesConfig& pieces,
                          const LinksConfig& links, int threads = 1);

/// Groups of pieces that may be one object each, described but not yet judged. Cues that are switched off are neutral.
/// also: groups that are proposed beside those of proposeGroups(), whatever their number; pieces ascending.
std::vector<GroupHypothesis> proposeObjects(const Frame& frame, const Table& table, const EdgeMap& edges,
                                            const PieceGraph& graph, const std::vector<Link>& links,
                                            const GroupingConfig& config, int threads,
                                            const std::vector<std::vector<int>>& also = {});

/// Sets the objectness of each group.
void judgeGroups(const LearnedObjectness& model, std::vector<GroupHypothesis>& groups, int threads = 1);

}  // namespace objectness

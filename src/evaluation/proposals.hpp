// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "evaluation/fixed_boxes.hpp"
#include "evaluation/true_boxes.hpp"
#include "objectness_segmentation/result.hpp"

namespace objectness::evaluation {

/// How many boxes of a list are kept, best first.
constexpr std::array<int, 5> kKeptBoxes{1, 5, 10, 20, 100};

/// Share of the true boxes that one of the first kKeptBoxes[i] boxes overlaps (intersection over union) by at least a
/// half and by at least 0.7.
struct BoxRecall {
  std::array<double, kKeptBoxes.size()> at_50{}, at_70{};
};

BoxRecall boxRecall(const std::vector<OrientedBox>& boxes, const std::vector<TrueBox>& truth);

/// The rectangle of the points above the table in the table frame; its corners are both the origin when there are none.
Footprint footprintOf(const Frame& frame, const Table& table, const ObjectPoints& object_points);

/// What the objectness measure is worth by itself, in one scene.
struct ProposalMetrics {
  int objects = 0;       ///< true boxes
  int proposals = 0;     ///< boxes that the filtering left
  BoxRecall objectness;  ///< of Segmentation::proposals
  BoxRecall fixed;       ///< of fixedBoxes() over the same points
  /// Paper Fig. 4 (c): the points above the table within the box of highest objectness, against the object that has
  /// most of them. Precision: share of them that are the object's; recall: share of the object's pixels among them.
  /// Void pixels do not count. 0 when there is no box or it holds no object.
  double best_box_precision = 0, best_box_recall = 0;
};

/// labels: H x W as SceneImages::true_labels; margin_m: FilterConfig::box_margin_m.
ProposalMetrics measureProposals(const Frame& frame, const Segmentation& result, const cv::Mat_<ushort>& labels,
                                 const std::vector<TrueBox>& truth, double margin_m);

}  // namespace objectness::evaluation

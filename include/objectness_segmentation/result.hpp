// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/stage_timer.hpp"
#include "objectness_segmentation/scene_observation.hpp"
#include "objectness_segmentation/segments/segment.hpp"
#include "objectness_segmentation/segments/unmeasured.hpp"

namespace objectness {

/// What was done and how long it took: read by the tools, the messages and the diagnostics alike.
struct Report {
  StageTimes timings_ms;             ///< per stage, in order; "total" last
  std::vector<std::string> remarks;  ///< those of the frame, and what makes the result doubtful: sentences

  // Nothing where the method has no such figure, or the stage was not reached.
  std::optional<std::int64_t> superpixels;
  std::optional<std::int64_t> object_points;  ///< paper's method
  std::optional<std::int64_t> edge_points;    ///< paper's method: of these, on edges
  std::optional<std::int64_t> boxes_sampled;  ///< paper's method
  std::optional<std::int64_t> boxes_scored;   ///< of these, passed the gates
  std::optional<std::int64_t> boxes_passed;   ///< of these, reached the objectness threshold
  std::optional<bool> boxes_bounded;          ///< the search skipped what cannot reach the threshold
  std::optional<std::int64_t> pieces;         ///< default method
  std::optional<std::int64_t> pairs;          ///< default method: of pieces
  std::optional<std::int64_t> hypotheses;     ///< what the objects were chosen among
  std::optional<bool> selection_proven;       ///< default method: the choice is the best there is
  std::optional<std::int64_t> background;     ///< segments that were judged to be none of the table's objects
  std::optional<std::int64_t> unmeasured;     ///< things without depth
  std::optional<std::int64_t> segments;
  std::optional<double> selection_value;   ///< default method: of the choice
  std::optional<double> selection_bound;   ///< default method: no choice has more
  std::optional<double> selection_gap;     ///< default method: between the two, as a share of the bound
  std::optional<double> annealing_gap;     ///< default method: the same of simulated annealing, where it was compared
  std::optional<double> search_threshold;  ///< paper's method: objectness that a box had to reach
  std::optional<double> selection_cost;    ///< paper's method: of Sec. 4.2

  /// Calls visit(name, figure) for each of them, in the order in which they are written.
  template <class Self, class Visitor>
  static void figures(Self& self, Visitor&& visit) {
    visit("superpixels", self.superpixels);
    visit("object_points", self.object_points);
    visit("edge_points", self.edge_points);
    visit("boxes_sampled", self.boxes_sampled);
    visit("boxes_scored", self.boxes_scored);
    visit("boxes_passed", self.boxes_passed);
    visit("boxes_bounded", self.boxes_bounded);
    visit("pieces", self.pieces);
    visit("pairs", self.pairs);
    visit("hypotheses", self.hypotheses);
    visit("selection_proven", self.selection_proven);
    visit("background", self.background);
    visit("unmeasured", self.unmeasured);
    visit("segments", self.segments);
    visit("selection_value", self.selection_value);
    visit("selection_bound", self.selection_bound);
    visit("selection_gap", self.selection_gap);
    visit("annealing_gap", self.annealing_gap);
    visit("search_threshold", self.search_threshold);
    visit("selection_cost", self.selection_cost);
  }
};

/// Everything that is known about a frame. When status is not ok(), what the stages before the failure found is kept.
struct Segmentation : SceneObservation {
  /// What the objects were chosen among, best objectness first: the boxes of all groups, or for the paper's method what
  /// the filtering of Sec. 4.1 leaves.
  std::vector<RankedBox> proposals;
  std::vector<Segment> segments;       ///< best objectness first
  cv::Mat_<ushort> labels;             ///< H x W: 0 nothing, 1 table, 2 + i: segments[i]
  std::vector<Unmeasured> unmeasured;  ///< things without depth on the table; labels are 0 there
  Report report;
};

}  // namespace objectness

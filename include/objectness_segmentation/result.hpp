// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "objectness_segmentation/common/stage_timer.hpp"
#include "objectness_segmentation/scene_observation.hpp"
#include "objectness_segmentation/segments/segment.hpp"
#include "objectness_segmentation/segments/unmeasured.hpp"

namespace objectness {

/// What was done and how long it took: read by the tools, the messages and the diagnostics alike.
struct Report {
  StageTimes timings_ms;  ///< per stage, in order; "total" last
  /// "superpixels", "hypotheses", "segments"; default method: "pieces", "pairs", "selection_proven"; paper's method:
  /// "object_points", "edge_points", "boxes_sampled", "boxes_scored", "boxes_passed", "boxes_bounded".
  std::vector<std::pair<std::string, std::int64_t>> counts;
  /// Default method: "selection_value", "selection_bound", "selection_gap"; paper's method: "search_threshold",
  /// "selection_cost".
  std::vector<std::pair<std::string, double>> values;
  std::vector<std::string> remarks;  ///< those of the frame, and what makes the result doubtful: sentences
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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/stage_timer.hpp"
#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/scene/table.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace objectness {

/// The cues of one box, paper Eq. 1, 2, 4 and 5. Areas in squares, volumes in cubes of one voxel's side.
struct CueValues {
  double edge_density = 0;  ///< delta_i, Eq. 1
  double outer_edges = 0;   ///< delta_o, Eq. 2
  double straddling = 0;    ///< delta_l, Eq. 4
  double free_space = 0;    ///< delta_f, Eq. 5
};

/// One object: the selected box and the pixels that are its own.
struct Segment {
  OrientedBox box;
  double objectness = 0;  ///< delta, Eq. 6
  CueValues cues;
  std::vector<int> pixels;  ///< indices v * width + u, ascending; in no other segment
};

/// What was done and how long it took: read by the tools, the messages and the diagnostics alike.
struct Report {
  StageTimes timings_ms;                                   ///< per stage, in order; "total" last
  std::vector<std::pair<std::string, std::int64_t>> counts;  ///< "boxes_sampled", "boxes_scored", "boxes_passed", ...
};

/// Everything that is known about a frame. When status is not ok(), what the stages before the failure found is kept.
struct Segmentation {
  Status status;
  Table table;
  ObjectPoints object_points;
  EdgeMap edges;
  Superpixels superpixels;
  std::vector<Segment> segments;  ///< best objectness first
  cv::Mat_<ushort> labels;        ///< H x W: 0 nothing, 1 table, 2 + i: segments[i]
  Report report;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// TableClusters without depth: glass, black or shiny things, things too near to the sensor. All that is known of one
/// is a compact hole in the picture of the table. Lengths in metres, in the camera's optical frame (REP 103). No
/// errors: a picture without such holes gives an empty list.

#include <optional>
#include <vector>

#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/segments/segment.hpp"

namespace objectness {

struct UnmeasuredConfig {
  bool report = true;
  double min_width_m = 0.03;
  double noise_factor = 3.0;
  double min_table_share = 0.65;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("report", self.report, "compact holes in the table that nothing explains are reported, apart from objects");
    visit("min_width_m", self.min_width_m, Range{0.005, 0.5}, "a circle this wide fits into a hole that is reported");
    visit("noise_factor", self.noise_factor, Range{1, 20},
          "and one this many times as wide as into nine of ten holes that the sensor's noise leaves in the table");
    visit("min_table_share", self.min_table_share, Range{0, 1}, "the least share of table in what is around the hole");
  }
};

/// A compact hole in the table: something stands or lies there that the sensor cannot measure.
struct Unmeasured {
  /// Where the rays through the hole's outermost pixels meet the table: the thing's foot is within, and what it hides
  /// of the table. Counter-clockwise seen from above, on the table's plane.
  std::vector<Eigen::Vector3d> outline;
  int pixels = 0;          ///< of the picture, without depth
  double area_m2 = 0;      ///< of the table behind these pixels
  double table_share = 0;  ///< of what is around the hole, 0..1: how surely it lies on the table
  double noise_ratio = 0;  ///< of the hole's width to that of the sensor's own holes: how surely it is none of these
  /// Where the outline is longer, away from the camera, than wide: the upright box of a thing that is as deep as it is
  /// wide. z away from the table, x away from the camera. Nothing otherwise: what lies flat looks the same.
  std::optional<OrientedBox> box;
};

/// The holes that nothing explains, in the order of their first pixels. Explained are:
/// - what is no wider than the frame's own holes, or min_width_m, or not compact: noise, slits, ragged ends of depth;
/// - what touches the end of the picture, or is not surrounded by table: beyond the sensor's range, within an object;
/// - the strip beside or behind a nearer thing that one of the sensor's two eyes does not see (any side of it);
/// - what lies in the picture of a segment's box: the thing is known.
/// labels: labelImage() of the segments, which have their whole boxes. Reads nothing but its arguments.
std::vector<Unmeasured> findUnmeasured(const Frame& frame, const Table& table, const ObjectPoints& above,
                                       const cv::Mat_<ushort>& labels, const std::vector<Segment>& segments,
                                       const UnmeasuredConfig& config);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "integral/cue_points.hpp"
#include "objectness/objectness.hpp"
#include "objectness_segmentation/segments/segment.hpp"
#include "objectness_segmentation/segments/segments_config.hpp"
#include "objectness_segmentation/segments/support.hpp"

namespace objectness {

/// A selected box with the grid it is measured in.
struct SelectedBox {
  ScoredBox scored;
  Grid grid;
};

/// The box in the camera's optical frame, metres.
OrientedBox orientedBox(const Box& box, const Grid& grid, const Eigen::Isometry3d& T_table_camera);

/// Gives every object point to at most one box (paper Sec. 4: a segment is what falls within a box; a point in several
/// goes to the one of highest objectness). boxes: best first; margin_m: as in FilterConfig::box_margin_m.
/// follow_superpixels: past the paper, whole superpixels follow the box that holds most of them, and other points their
/// nearest segment. Best segment first.
std::vector<Segment> cutSegments(const Frame& frame, const Eigen::Isometry3d& T_table_camera, const CuePoints& points,
                                 const std::vector<SelectedBox>& boxes, double margin_m, bool follow_superpixels,
                                 const SegmentsConfig& config, int threads = 1);

/// Takes segments without pixels out of the list. What stood on one of them stands on something that is no segment.
void dropEmpty(std::vector<Segment>& segments);

/// Takes the pixels of Frame::bridged out of the segments, and segments without any other out of the list.
void keepMeasured(const std::vector<int>& bridged, std::vector<Segment>& segments);

/// The label image of Segmentation::labels: 0 nothing, 1 table, 2 + i: segments[i]. A bridged pixel has the label that
/// all others of its 3 x 3 neighbourhood share, otherwise 0.
cv::Mat_<ushort> labelImage(const cv::Mat_<uchar>& on_table, const std::vector<int>& bridged,
                            const std::vector<Segment>& segments);

}  // namespace objectness

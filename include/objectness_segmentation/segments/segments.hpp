// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/integral/cue_points.hpp"
#include "objectness_segmentation/objectness/objectness.hpp"
#include "objectness_segmentation/segments/support.hpp"

namespace objectness {

struct SegmentsConfig {
  bool follow_superpixels = true;
  double min_superpixel_share = 0.5;
  double max_reach_m = 0.04;
  double max_step_m = 0.015;
  int min_pixels = 100;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(
        "follow_superpixels", self.follow_superpixels,
        "paper's boxes: whole superpixels follow the box that holds most of them, other points their nearest segment; "
        "off: the pixels within the box");
    visit("min_superpixel_share", self.min_superpixel_share, Range{0, 1},
          "paper's boxes: a superpixel follows a box that holds at least this share of it");
    visit("max_reach_m", self.max_reach_m, Range{0, 0.5},
          "paper's boxes: how far along the surface a point follows its nearest segment");
    visit("max_step_m", self.max_step_m, Range{0.001, 0.1},
          "paper's boxes: neighbouring pixels farther apart are not on one surface");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "smaller segments are dropped");
  }
};

/// One object: its box and the pixels that are its own.
struct Segment {
  /// Of the whole object, from its support to its top (completeBoxes()); before that step, as visible_box.
  OrientedBox box;
  /// What the segmentation itself says. Default method: the tight box of what is seen; paper's: the selected box.
  OrientedBox visible_box;
  bool round = false;        ///< a thing of revolution about the box's z axis, its yaw is that of the view
  Support support;           ///< what it stands on
  std::vector<int> carried;  ///< indices of the segments that stand on it, ascending
  double objectness = 0;     ///< paper's method: delta of Eq. 6; default: expected overlap with an object, 0..1
  /// Paper's method: as CueValues says. Default: edge_density, outer_edges and straddling of GroupCues, free_space is
  /// GroupCues::free (a share of the box's volume), free_voxels 0.
  CueValues cues;
  std::vector<int> pixels;  ///< indices v * width + u, ascending, of measured points; in no other segment
};

/// A selected box with the grid it is measured in.
struct SelectedBox {
  ScoredBox scored;
  Grid grid;
};

/// The box in the camera's optical frame, metres.
OrientedBox orientedBox(const Box& box, const Grid& grid, const Eigen::Isometry3d& T_table_camera);

/// Gives every object point to at most one box (paper Sec. 4: a segment is what falls within a box; a point in several
/// goes to the one of highest objectness). boxes: best first; margin_m: as in FilterConfig::box_margin_m. Best segment
/// first.
std::vector<Segment> cutSegments(const Frame& frame, const Eigen::Isometry3d& T_table_camera, const CuePoints& points,
                                 const std::vector<SelectedBox>& boxes, double margin_m, const SegmentsConfig& config,
                                 int threads = 1);

/// What segments[0] is called in label images, clouds, messages and pictures; 1 is the table, 0 nothing.
constexpr int kFirstObjectLabel = 2;
constexpr int kTableLabel = 1;

/// Takes segments without pixels out of the list. What stood on one of them stands on something that is no segment.
void dropEmpty(std::vector<Segment>& segments);

/// Takes the pixels of Frame::bridged out of the segments, and segments without any other out of the list.
void keepMeasured(const std::vector<int>& bridged, std::vector<Segment>& segments);

/// The label image of Segmentation::labels: 0 nothing, 1 table, 2 + i: segments[i]. A bridged pixel has the label that
/// all others of its 3 x 3 neighbourhood share, otherwise 0.
cv::Mat_<ushort> labelImage(const cv::Mat_<uchar>& on_table, const std::vector<int>& bridged,
                            const std::vector<Segment>& segments);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "segments/compact_holes.hpp"

namespace objectness {

/// Share of table among what is around a hole, within half its radius; NaN where that is mostly something else. Pixels
/// over the table that belong to no segment are left out: a thing without depth mostly shows some of itself. labels: as
/// Segmentation::labels; height_m: as ObjectPoints has it.
double tableAround(const CompactHole& hole, const cv::Mat_<ushort>& labels, const cv::Mat_<float>& height_m);

/// Whether most of a hole lies in gaps of rows or of columns that are no wider than what one of the sensor's two eyes
/// does not see beside the nearer end of the gap.
bool isShadow(const CompactHole& hole, const Frame& frame);

/// The pictures of the segments' boxes, and whether most of a hole lies in one of them.
class KnownThings {
 public:
  KnownThings(const PinholeCamera& camera, const std::vector<Segment>& segments);

  bool hold(const CompactHole& hole) const;

 private:
  std::vector<std::vector<cv::Point>> pictures_;  ///< convex
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// Where an object is in the picture: truth that can be read by eye.
struct PictureBox {
  cv::Rect2d box;  ///< visible extent, pixels; right and bottom just outside
  cv::Point seed;  ///< a pixel on the visible surface
};

/// The boxes of objects.yaml in a scene folder:
///     objects:
///       - {box: [u0, v0, u1, v1], seed: [u, v]}
/// Other keys are left alone, entries without a box left out. Empty when there is no such file; kBadInput with the
/// reason when an entry cannot be read.
Result<std::vector<PictureBox>> loadPictureBoxes(const std::string& scene_folder);

/// How many objects are found, told by the boxes around them. Objects and segments are paired one to one, the sum of
/// the overlaps (intersection over union of an object's box and the bounding box of a segment) being the largest.
struct PictureBoxCounts {
  int objects = 0;
  int found = 0;     ///< objects whose pair overlaps by 0.5 at least
  int tight = 0;     ///< by 0.7
  int merged = 0;    ///< objects not found whose seed lies in a segment with the seed of another one
  int segments = 0;  ///< of any size
  int stray = 0;     ///< segments of kMinStrayPixels or more that overlap no object by 0.1

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("objects", self.objects);
    visit("found", self.found);
    visit("tight", self.tight);
    visit("merged", self.merged);
    visit("segments", self.segments);
    visit("stray", self.stray);
  }
};

constexpr int kMinStrayPixels = 300;

/// labels: 0 nothing, 1 table, 2 and above one segment each. Seeds must lie within them.
PictureBoxCounts countPictureBoxes(const cv::Mat_<ushort>& labels, const std::vector<PictureBox>& truth);

}  // namespace objectness::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace objectness {

/// Pixels first..last-1 of a row that are set, and the connected part they belong to.
struct Run {
  int row, first, last;
  int part;
};

/// The connected parts of a mask as runs, row by row: few, where the mask has many pixels.
struct MaskComponents {
  std::vector<Run> runs;
  int count = 0;  ///< parts 0..count-1, in the order of their first pixels
};

enum class Neighbours { kFour, kEight };

/// Parts of the pixels that are not 0.
MaskComponents findComponents(const cv::Mat_<uchar>& mask, Neighbours neighbours);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

/// How objects are found on the table.
enum class SegmentationMethod {
  kObjectness,  ///< groups of superpixels of any height and tilt, scored by the model
  kPaper,       ///< the paper's boxes, whose superpixels and neighbouring points follow them
  kBoxes        ///< the same boxes; a segment is the points within one
};

/// The values of an enumerated parameter in presets, on the command line and in ROS, in the order of the enumerators.
inline constexpr std::array<const char*, 3> kMethodNames{"objectness", "paper", "boxes"};

struct PipelineConfig {
  SegmentationMethod method = SegmentationMethod::kObjectness;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("method", self.method,
          "objectness: groups of superpixels, scored by what was learned; paper: the paper's boxes, which superpixels "
          "follow; boxes: the points within these boxes");
  }
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// A picture of the result, H x W: segments in the colours of objectColor() with their outlines, their labels and their
/// boxes as wireframes (edges at the back thin), over the colour image, or over the depth in grey when there is none.
cv::Mat_<cv::Vec3b> drawOverlay(const Frame& frame, const Segmentation& result);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Sees through a depth image that is riddled with small holes: by registration to a finer camera, or by lost pixels.
/// A frame with as few as a depth camera itself leaves, mostly at boundaries, stays as it is. Otherwise, with a remark,
/// gives pixels without depth a point on their ray where a line of the image (row, column or diagonal) leads across at
/// most max_gap_px of them from one surface to the same surface: the two ends differ by no more than noise or a grazing
/// surface explain. Inverse depth is interpolated, which is exact on a plane. Only measured ends count, so wide holes
/// stay holes. Records the pixels in Frame::bridged.
void bridgeGaps(int max_gap_px, Frame& frame);

}  // namespace objectness

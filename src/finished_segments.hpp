// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/config.hpp"
#include "stages.hpp"

namespace objectness {

/// What follows once `result` has its segments, however they were chosen: background is taken out, boxes come to rest,
/// what was not measured goes, and labels are drawn.
void finishSegments(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result);

}  // namespace objectness

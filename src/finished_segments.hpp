// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/config.hpp"
#include "stages.hpp"

namespace objectness {

/// What follows once `result` has its segments, however they were chosen: background is taken out, what was not
/// measured goes, labels are drawn, and boxes become those of whole objects.
void finishSegments(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result);

}  // namespace objectness

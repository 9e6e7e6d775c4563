// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/config.hpp"
#include "stages.hpp"

namespace objectness {

/// The paper's method (Sec. 2 to 4): scores all boxes of an exhaustive sampling with weights set by hand, filters them
/// and chooses the globally consistent set. Takes the observation in `result`; adds proposals and segments, or an error
/// status (kVolumeTooLarge).
void searchBoxes(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result);

}  // namespace objectness

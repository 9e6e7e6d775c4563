// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/remembered_groups.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "stages.hpp"

namespace objectness {

/// The default method, past the paper: groups of superpixels of any height and tilt, scored by the model or, with
/// grouping.learned off, by rules. Takes the observation in `result`; adds proposals and segments.
/// model: nullptr for the built-in one. memory: of the frame before, nullptr for none.
void groupPieces(const Frame& frame, const Config& config, const LearnedObjectness* model, const GroupingMemory* memory,
                 const Stages& stage, Segmentation& result);

}  // namespace objectness

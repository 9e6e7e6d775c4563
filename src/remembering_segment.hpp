// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/remembered_groups.hpp"
#include "objectness_segmentation/pipeline.hpp"

namespace objectness {

/// segment() of a frame that follows another. model: nullptr for defaultModel(). memory: nullptr for none; the paper's
/// method does not heed it.
Segmentation segmentRemembering(const Frame& frame, const Config& config, const LearnedObjectness* model,
                                const GroupingMemory* memory, const std::atomic<bool>* cancel);

}  // namespace objectness

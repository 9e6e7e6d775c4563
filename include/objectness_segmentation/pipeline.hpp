// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// All of it in one call: table, object points, edges and superpixels; then groups of superpixels, judged by the model
/// that comes with the package, and the choice among them, or with another config.pipeline.method the paper's search of
/// boxes, their filtering and selection.
///
/// The same frame and config give the same result for any number of threads (timings apart). Never throws for bad data:
/// the reason is in Segmentation::status. `cancel`, when given, is looked at between stages and, in the paper's search,
/// between box angles.
Segmentation segment(const Frame& frame, const Config& config, const std::atomic<bool>* cancel = nullptr);

/// The same with a model of one's own in the place of defaultModel().
Segmentation segment(const Frame& frame, const Config& config, const LearnedObjectness& model,
                     const std::atomic<bool>* cancel = nullptr);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/config.hpp"
#include "stages.hpp"

namespace objectness {

// The front end, the only one there is: both methods, the learning and the baselines call it, so that they see the
// same. `scene` is filled stage by stage: what was found stays there when a later stage fails, throws or is cancelled.
// The observation does not depend on config.runtime.threads.

/// Normals, table, refined normals and the points on the table (paper Sec. 2): what any segmenter of table tops needs.
void observeTable(const Frame& frame, const Config& config, const Stages& stage, SceneObservation& scene);

/// The same, then edges and superpixels (paper Sec. 3.1 to 3.3), which are this package's own. Superpixels are those of
/// config.pipeline.method.
void observeScene(const Frame& frame, const Config& config, const Stages& stage, SceneObservation& scene);

}  // namespace objectness

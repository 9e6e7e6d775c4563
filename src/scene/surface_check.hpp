// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// kBadInput where most pixels with depth lie beside one without, so that there are no surfaces to be segmented:
/// sparse, torn or interleaved depth.
Status checkSurfaces(const Frame& frame);

}  // namespace objectness

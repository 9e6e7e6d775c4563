// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// A remark when what was seen is so large or so small, or so far off, that the unit of the depth is probably another
/// one; empty otherwise. Looks at the table and the segments, or without a table at the depth alone.
std::string doubtfulScale(const Frame& frame, const Segmentation& result);

}  // namespace objectness

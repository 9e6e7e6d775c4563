// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

/// Metres of a unit of 16-bit depth, from either way to say it: units of a metre ("5000") or metres of a unit
/// ("0.0002", "1/5000"). kBadInput when it is neither, or no unit that depth is stored in (1 um to 2 cm). The message
/// goes on from "a depth scale that".
Result<double> depthUnit(const std::string& scale);

}  // namespace objectness

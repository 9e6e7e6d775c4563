// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// Fills hull and hull_measured of a table that has its plane, frame, extent and noise: the border of the extent's
/// core, drawn to where the picture shows the surface end.
void traceOutline(const Frame& frame, Table& table);

}  // namespace objectness

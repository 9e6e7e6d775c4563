// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/scene/table.hpp"

namespace objectness_segmentation {

/// findTable() gives a normal and a hull; what never ran leaves neither.
inline bool hasTable(const objectness::Table& table) { return !table.hull.empty() || table.d != 0; }

/// a b c d, or nothing without a table.
std::vector<float> planeCoefficients(const objectness::Table& table);

}  // namespace objectness_segmentation

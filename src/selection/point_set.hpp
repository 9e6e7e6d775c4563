// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace objectness {

/// A set of scene points, one bit each.
using PointSet = std::vector<std::uint64_t>;

int countPoints(const PointSet& set);
int countShared(const PointSet& a, const PointSet& b);
bool sharePoints(const PointSet& a, const PointSet& b);
std::vector<int> listPoints(const PointSet& set);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "integral/cue_points.hpp"

namespace objectness {

/// S' of paper Sec. 4.2: the points above the table thinned to one a cell of `spacing_m`, the first in raster order.
/// Table frame, metres; points over `top_m` are left out, no box can hold them.
std::vector<Eigen::Vector3f> thinPoints(const std::vector<Eigen::Vector3f>& points, double spacing_m, double top_m);

}  // namespace objectness

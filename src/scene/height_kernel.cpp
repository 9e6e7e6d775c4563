// SPDX-License-Identifier: BSD-3-Clause
#include "scene/height_kernel.hpp"

#include <limits>

#include "common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("avx2")
void measureHeights(const float* points, int width, const HeightRule& rule, float* height_m, float* threshold_m,
                    int* cell) {
  const HeightRule r = rule;
  const float columns = static_cast<float>(r.columns), rows = static_cast<float>(r.rows);
  const float nan = std::numeric_limits<float>::quiet_NaN();
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) {
    const float x = points[3 * u], y = points[3 * u + 1], z = points[3 * u + 2];
    const float height = x * r.normal[0] + (y * r.normal[1] + z * r.normal[2]) + r.d;
    // Depth noise moves a point along its ray: seen at a grazing angle, little of it is height.
    const float ratio = (height - r.d) / z;
    const float noise = r.sigmas * (r.constant + r.quadratic * z * z) * (ratio < 0 ? -ratio : ratio);
    const float at_least = r.low < noise ? noise : r.low;
    const float threshold = at_least < r.high ? at_least : r.high;
    height_m[u] = height;
    threshold_m[u] = z > 0 ? threshold : nan;
    const float column = (x * r.x_axis[0] + (y * r.x_axis[1] + z * r.x_axis[2]) - r.x_origin) * r.inverse_cell;
    const float row = (x * r.y_axis[0] + (y * r.y_axis[1] + z * r.y_axis[2]) - r.y_origin) * r.inverse_cell;
    const bool within = (z > 0) & (column >= 0) & (row >= 0) & (column < columns) & (row < rows);
    const int whole_column = static_cast<int>(within ? column : 0.f), whole_row = static_cast<int>(within ? row : 0.f);
    cell[u] = within ? whole_row * r.columns + whole_column : -1;
  }
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/plane_sums.hpp"

namespace objectness {

/// Points with their normals, how far from a plane they may lie, and their weight in a fit, an array each.
struct SampleColumns {
  const float *x, *y, *z, *normal_x, *normal_y, *normal_z, *tolerance_m;
  const double* weight;
  int count;
};

/// A plane n . p + d = 0 and what fits it: points within so many of their tolerances, with a normal as near as this.
struct PlaneTest {
  float x, y, z, d;
  float tolerances, min_cosine;
};

/// fits[i]: 1 where sample i fits the plane, else 0. Returns how many do.
int markFitting(const SampleColumns& samples, const PlaneTest& plane, unsigned char* fits);

/// Of the samples where fits is set, added up in their order.
PlaneSums sumFitting(const SampleColumns& samples, const unsigned char* fits);

}  // namespace objectness

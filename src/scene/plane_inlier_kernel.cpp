// SPDX-License-Identifier: BSD-3-Clause
#include "scene/plane_inlier_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {

OBJECTNESS_CLONES("avx2")
int markFitting(const SampleColumns& samples, const PlaneTest& plane, unsigned char* fits) {
  const SampleColumns s = samples;
  const PlaneTest p = plane;
  for (int i = 0; i < s.count; ++i) {
    const float height = s.x[i] * p.x + (s.y[i] * p.y + s.z[i] * p.z) + p.d;
    const float cosine = s.normal_x[i] * p.x + (s.normal_y[i] * p.y + s.normal_z[i] * p.z);
    const bool near = (height < 0 ? -height : height) <= p.tolerances * s.tolerance_m[i];
    fits[i] = static_cast<unsigned char>(near & (cosine >= p.min_cosine));
  }
  int count = 0;
  for (int i = 0; i < s.count; ++i) count += fits[i];
  return count;
}

PlaneSums sumFitting(const SampleColumns& samples, const unsigned char* fits) {
  PlaneSums sums;
  for (int i = 0; i < samples.count; ++i) {
    if (fits[i]) sums.add(samples.x[i], samples.y[i], samples.z[i], samples.weight[i]);
  }
  return sums;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/surface_samples.hpp"

namespace objectness {

/// The large planes of a view, most samples first: seeded RANSAC with normals, one plane after the other.
std::vector<Plane> findPlanes(const SurfaceSamples& samples, int threads = 1);

}  // namespace objectness

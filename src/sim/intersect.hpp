// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sim/shapes.hpp"

namespace objectness::sim {

/// The first point of the shape's surface on the ray, in the shape's own frame. Exact: every surface is a plane, a
/// sphere, a cylinder or a cone, so that t is the root of a linear or quadratic equation.
std::optional<Hit> intersect(const Shape& shape, const Ray& ray);

}  // namespace objectness::sim

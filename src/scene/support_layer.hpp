// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/table_evidence.hpp"

namespace objectness {

/// Fits the plane to the surface that lies under everything: where more book tops than table lie within a plane's
/// tolerance, the plane settles on the books or between. Returns the plane of the lower of two parallel layers when
/// there are two, otherwise the plane refitted to its own surface. seen: of the plane, by seePlane().
Plane settleOnSupportLayer(const SurfaceSamples& samples, const Plane& plane, const SeenPlane& seen);

}  // namespace objectness

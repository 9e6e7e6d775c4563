// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Reads a PCD file (ascii, binary or binary_compressed) with float or double fields x, y, z and, if there is one, a
/// colour field rgb or rgba, in metres. A VIEWPOINT becomes the cloud's T_cloud_sensor. kBadInput: missing, empty, cut
/// off, no PCD, more than 64 million points, no x, y, z.
Result<RawCloud> loadPcd(const std::string& path);

}  // namespace objectness

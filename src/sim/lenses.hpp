// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/scene/camera.hpp"

namespace objectness::sim {

/// The size of the depth image (registered to the colour camera where the device does that) and the lens of a camera
/// that is on many robots: pixels, distortion-free, the principal point in the middle of the image. The focal lengths
/// are what the drivers of such devices publish, rounded; they follow from the fields of view in the makers' data
/// sheets.
struct Lens {
  std::string name;
  PinholeCamera camera;
};

/// From small to large images, 320 x 240 to 1920 x 1080.
const std::vector<Lens>& lenses();

/// Null when there is none of that name.
const PinholeCamera* findLens(const std::string& name);

/// The names, separated by ", ".
std::string lensNames();

}  // namespace objectness::sim

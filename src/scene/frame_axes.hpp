// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

constexpr const char* kInOpticalFrame = "in its optical frame (x right, y down, z forward)";

/// A convention for the axes of a camera that is not the optical one.
struct FrameAxes {
  std::string name;
  Eigen::Matrix3f R_optical_cloud;
};

/// Those that clouds are found in: REP 103 bodies and OpenGL.
const std::vector<FrameAxes>& otherAxes();

/// "the cloud is not in its camera's optical frame ...": with what it is instead and what to do.
std::string notOptical(const RawCloud& cloud, const std::string& what_instead);

/// notOptical() of an organized cloud that is a pinhole view from another frame than the optical one; "" of all others.
std::string otherFrameOf(const RawCloud& cloud);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "scene/frame_axes.hpp"

namespace objectness {

const std::vector<FrameAxes>& otherAxes() {
  static const std::vector<FrameAxes> axes = [] {
    Eigen::Matrix3f body, open_gl;
    body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    open_gl << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    return std::vector<FrameAxes>{{"its x axis points forward and z up, as in a robot's frames", body},
                                  {"its z axis points backward and y up, as in OpenGL", open_gl}};
  }();
  return axes;
}

std::string notOptical(const RawCloud& cloud, const std::string& what_instead) {
  const std::string subject =
      cloud.frame_id.empty() ? "the cloud is not in" : "the cloud's frame '" + cloud.frame_id + "' is not";
  return subject + " the camera's optical frame (x right, y down, z forward): " + what_instead +
         "; transform it into the optical frame";
}

}  // namespace objectness

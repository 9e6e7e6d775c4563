// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "objectness_segmentation/scene/camera.hpp"
#include "sim/bodies.hpp"

namespace objectness::sim {

/// The first surface behind a pixel.
struct SurfacePixel {
  const Body* body = nullptr;  ///< null: nothing there
  double depth_m = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< camera's optical frame, unit, towards the camera
  bool lit = false;                                  ///< the projector's ray gets there
};

/// What is to be seen through every pixel, before any sensor: exact.
struct SurfaceView {
  PinholeCamera camera;
  std::vector<SurfacePixel> pixels;  ///< row by row
  cv::Mat_<cv::Vec3b> color;         ///< H x W, BGR; shaded by a distant light
  std::map<int, int> pixels_seen;    ///< by label
  std::map<int, int> pixels_alone;   ///< by label: how many there would be if nothing else were in the world

  const SurfacePixel& at(int v, int u) const { return pixels[static_cast<std::size_t>(v) * camera.width + u]; }
};

/// projector: its place in the camera's optical frame; without one everything is lit. threads: 0 one per processor; the
/// result does not depend on it. `bodies` must outlive the view.
SurfaceView viewSurfaces(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                         const PinholeCamera& camera, const std::optional<Eigen::Vector3d>& projector, int threads = 0);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Reads a scene folder: depth.png (16 bits, 0 = none; InputConfig::depth_unit_m), color.png (optional; one that cannot
/// be used or is of another size is a remark) and camera.yaml (see loadImageCamera()). `fallback` is used when there is
/// no camera.yaml. Messages name the file of the folder they are about.
Result<Frame> loadSceneFolder(const std::string& folder, const std::optional<ImageCamera>& fallback,
                              const InputConfig& config);

/// The files of a scene folder; what is empty is left out.
struct SceneImages {
  PinholeCamera camera;
  cv::Mat_<ushort> depth_mm;     ///< H x W, 0 = none
  cv::Mat_<cv::Vec3b> color;     ///< H x W, BGR
  cv::Mat_<ushort> true_labels;  ///< H x W, as common/true_labels.hpp says
};

/// Writes depth.png, color.png, camera.yaml and labels.png into `folder`, which is made.
Status saveSceneFolder(const std::string& folder, const SceneImages& scene);

}  // namespace objectness

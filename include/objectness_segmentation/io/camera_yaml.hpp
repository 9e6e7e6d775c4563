// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/camera.hpp"

namespace objectness {

/// Reads a camera as ROS writes it, either as a calibration file (image_width, camera_matrix: {data: [...]}, ...) or as
/// the text of a camera_info message (width, K: [...], ...).
///
/// The projection matrix counts, as it describes the rectified image; without one (or with one of zeros) the camera
/// matrix does, and then there must be no distortion: the points of an unrectified image do not lie on pinhole rays.
/// kBadInput: no such file, no YAML, entries missing; kBadCamera: values no rectified pinhole camera has.
Result<PinholeCamera> loadCamera(const std::string& path);

/// Writes a calibration file that loadCamera(), image_proc and camera_info_manager read.
Status saveCamera(const std::string& path, const PinholeCamera& camera);

}  // namespace objectness

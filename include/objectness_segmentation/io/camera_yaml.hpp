// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/image_camera.hpp"

namespace objectness {

/// Reads a camera as ROS writes it, either as a calibration file (image_width, camera_matrix: {data: [...]}, ...) or as
/// the text of a camera_info message (width, K: [...], binning_x, roi, ...), with a depth_scale (depthUnit()) beside it
/// or not.
///
/// The projection matrix counts, as it describes the rectified image; without one (or with one of zeros) the camera
/// matrix does, and with distortion the image is then one that is not rectified. Otherwise as imageCamera().
/// kBadInput: no such file, no YAML, entries missing; kBadCamera: values no camera has.
Result<ImageCamera> loadImageCamera(const std::string& path);

/// The camera of what is rectified already, as clouds are; kBadCamera when it is that of an image that is not.
Result<PinholeCamera> rectifiedCamera(const ImageCamera& camera);
Result<PinholeCamera> loadCamera(const std::string& path);

/// Writes a calibration file that loadCamera(), image_proc and camera_info_manager read.
Status saveCamera(const std::string& path, const PinholeCamera& camera);

}  // namespace objectness

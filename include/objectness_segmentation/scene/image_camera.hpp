// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/camera.hpp"

namespace objectness {

/// A camera as calibration files and camera_info messages describe it, with the names and meanings of
/// sensor_msgs/CameraInfo. What is zero or empty is not given.
struct CameraCalibration {
  struct Region {
    std::uint32_t x_offset = 0, y_offset = 0, width = 0, height = 0;
  };
  std::uint32_t width = 0, height = 0;  ///< of the whole image, pixels
  std::string distortion_model;         ///< "plumb_bob", "rational_polynomial", "equidistant"
  std::vector<double> D;                ///< distortion of the raw image, in OpenCV's order
  std::array<double, 9> K{};            ///< 3 x 3, row-major: of the raw image
  std::array<double, 12> P{};           ///< 3 x 4, row-major: of the rectified image
  std::uint32_t binning_x = 0, binning_y = 0;
  Region roi;  ///< pixels of the whole image
};

/// What a lens does to the image of a pinhole camera.
struct LensDistortion {
  std::string model;
  std::vector<double> D;
};

/// The camera of a depth image.
struct ImageCamera {
  ImageCamera() = default;
  /// Of a rectified image.
  ImageCamera(const PinholeCamera& rectified) : pinhole(rectified) {}

  PinholeCamera pinhole;               ///< of the image once it is rectified
  std::optional<LensDistortion> lens;  ///< set when the image certainly is not rectified yet
  double depth_unit_m = 0;             ///< metres of a unit of 16-bit depth, 0: not known
  std::vector<std::string> remarks;    ///< what is unusual about it, as Frame::remarks
};

/// The pinhole camera of the images that carry a calibration: P, or K when P is not given, with region of interest and
/// binning applied as in image_geometry. kBadCamera with the reason.
Result<PinholeCamera> pinholeCamera(const CameraCalibration& calibration);

/// The same with what is known of the lens. Calibrations with distortion come with raw and with rectified images. Only
/// without P, which describes the rectified one, it is certain that the image is raw (`lens` is set). Where P is the
/// same as K it may be: that is a remark when it would matter. kBadCamera also for a raw image with a distortion model
/// that is not known.
Result<ImageCamera> imageCamera(const CameraCalibration& calibration);

/// A remark for inputs that are taken as rectified and may not be; empty when that moves no pixel of the view by more
/// than one.
std::string lensRemark(const PinholeCamera& camera, const LensDistortion& lens);

/// The camera of an image of this size, which is `what` ("depth image") of the camera. One that is larger by the same
/// whole number both ways is taken as that of an image of which every so many-th row and column was kept, with a
/// remark. kSizeMismatch for other sizes, with what would help.
Result<PinholeCamera> cameraOfSize(const PinholeCamera& camera, int width, int height, const std::string& what,
                                   std::vector<std::string>& remarks);

}  // namespace objectness

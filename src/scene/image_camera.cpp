// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/image_camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "scene/lens.hpp"

namespace objectness {
namespace {

// A pixel of distortion is what calibrations are good to.
constexpr double kMaxShiftPx = 1.0;

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

bool hasP(const CameraCalibration& calibration) { return calibration.P[0] != 0; }

/// P of a camera that is rectified without another focal length, or of a driver that knows none but K.
bool sameAsK(const CameraCalibration& calibration) {
  const auto same = [&](int p, int k) {
    return std::abs(calibration.P[p] - calibration.K[k]) <= 1e-6 * std::abs(calibration.K[0]);
  };
  return same(0, 0) && same(2, 2) && same(5, 4) && same(6, 5);
}

/// Numbers of a message, too large for an image in every case where they do not fit.
int toSide(std::uint32_t pixels) {
  return static_cast<int>(std::min<std::uint32_t>(pixels, std::numeric_limits<int>::max()));
}

/// How many times the image fits the camera along one axis, when that is a whole number; its last row may be missing.
int wholeRatio(int camera, int image) {
  if (image < 1 || camera < image) return 0;
  const int ratio = static_cast<int>(std::lround(static_cast<double>(camera) / image));
  return image == camera / ratio || image == (camera + ratio - 1) / ratio ? ratio : 0;
}

}  // namespace

Result<PinholeCamera> pinholeCamera(const CameraCalibration& calibration) {
  const bool has_p = hasP(calibration);
  PinholeCamera camera;
  camera.fx = has_p ? calibration.P[0] : calibration.K[0];
  camera.fy = has_p ? calibration.P[5] : calibration.K[4];
  camera.cx = has_p ? calibration.P[2] : calibration.K[2];
  camera.cy = has_p ? calibration.P[6] : calibration.K[5];

  const CameraCalibration::Region& roi = calibration.roi;
  const bool has_roi = roi.width != 0 && roi.height != 0;
  const auto binning_x = std::max<std::uint32_t>(1, calibration.binning_x);
  const auto binning_y = std::max<std::uint32_t>(1, calibration.binning_y);
  if (has_roi) {
    camera.cx -= roi.x_offset;
    camera.cy -= roi.y_offset;
  }
  camera.fx /= binning_x;
  camera.cx /= binning_x;
  camera.fy /= binning_y;
  camera.cy /= binning_y;
  camera.width = toSide((has_roi ? roi.width : calibration.width) / binning_x);
  camera.height = toSide((has_roi ? roi.height : calibration.height) / binning_y);
  const Status valid = validate(camera);
  return valid.ok() ? Result<PinholeCamera>{{}, camera} : Result<PinholeCamera>::error(valid);
}

Result<ImageCamera> imageCamera(const CameraCalibration& calibration) {
  const Result<PinholeCamera> pinhole = pinholeCamera(calibration);
  if (!pinhole.ok()) return Result<ImageCamera>::error(pinhole.status);
  Result<ImageCamera> camera{{}, pinhole.value};
  const LensDistortion lens{calibration.distortion_model, calibration.D};
  if (lens.D.empty() || !distorts(lens)) return camera;
  if (!hasP(calibration)) {
    const Status known = validate(lens);
    if (!known.ok()) {
      return Result<ImageCamera>::error(StatusCode::kBadCamera,
                                        known.message + ": give rectified images (image_proc) and their camera");
    }
    camera.value.lens = lens;
  } else if (sameAsK(calibration)) {
    const std::string remark = lensRemark(pinhole.value, lens);
    if (!remark.empty()) camera.value.remarks.push_back(remark);
  }
  return camera;
}

std::string lensRemark(const PinholeCamera& camera, const LensDistortion& lens) {
  if (!validate(lens).ok()) return "";
  const double shift = largestShiftPx(camera, lens);
  if (!(shift > kMaxShiftPx)) return "";
  std::ostringstream remark;
  remark.precision(shift < 10 ? 2 : 3);
  remark << "the camera has lens distortion, up to " << shift
         << " px in view, and its projection matrix does not say that images are rectified: if the depth is not, sizes "
            "are wrong and flat things look bent; rectify it (image_proc, depth_image_proc), or if it is, give the "
            "camera without distortion";
  return remark.str();
}

Result<PinholeCamera> cameraOfSize(const PinholeCamera& camera, int width, int height, const std::string& what,
                                   std::vector<std::string>& remarks) {
  if (camera.width == width && camera.height == height) return {{}, camera};
  const std::string sizes =
      what + " is " + sizeText(width, height) + " but its camera is " + sizeText(camera.width, camera.height);
  const int ratio = wholeRatio(camera.width, width);
  if (ratio < 2 || wholeRatio(camera.height, height) != ratio) {
    return Result<PinholeCamera>::error(
        StatusCode::kSizeMismatch,
        sizes +
            ": give the camera of this very image; what was cut or scaled says so by its region of interest and "
            "binning (roi, binning_x, binning_y)");
  }
  PinholeCamera small = thinned(camera, ratio);
  small.width = width, small.height = height;
  remarks.push_back("the " + sizes + ": taken as one row and column in " + std::to_string(ratio) +
                    " of it; binning_x and binning_y of the camera say so for certain, roi if it is a part of it");
  return {{}, small};
}

}  // namespace objectness

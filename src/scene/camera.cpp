// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/camera.hpp"

#include <cmath>
#include <sstream>

#include "scene/image_limits.hpp"

namespace objectness {
namespace {

// Beyond these, rays and projections of sensible points overflow.
constexpr double kMinFocalImages = 1e-3, kMaxFocalImages = 1e3;
// Crops of a larger image may have their principal point outside; farther than this it is a mistake.
constexpr double kMaxPrincipalPointImages = 10;

bool focalLengthFits(double focal, int side) {
  return focal >= kMinFocalImages * side && focal <= kMaxFocalImages * side;
}

}  // namespace

PinholeCamera thinned(PinholeCamera camera, int step) {
  camera.fx /= step;
  camera.fy /= step;
  camera.cx /= step;
  camera.cy /= step;
  camera.width = (camera.width + step - 1) / step;
  camera.height = (camera.height + step - 1) / step;
  return camera;
}

Status validate(const PinholeCamera& camera) {
  std::ostringstream reason;
  const bool finite =
      std::isfinite(camera.fx) && std::isfinite(camera.fy) && std::isfinite(camera.cx) && std::isfinite(camera.cy);
  if (camera.width < 1 || camera.height < 1 || camera.width > kMaxSidePx || camera.height > kMaxSidePx) {
    reason << "camera size is " << camera.width << " x " << camera.height << ", must be within 1 and " << kMaxSidePx
           << " pixels a side";
  } else if (camera.width > kMaxPixels / camera.height) {
    reason << "camera size is " << camera.width << " x " << camera.height << ", must be at most " << kMaxPixels
           << " pixels in all";
  } else if (!finite) {
    reason << "camera intrinsics are not finite numbers: fx " << camera.fx << ", fy " << camera.fy << ", cx "
           << camera.cx << ", cy " << camera.cy;
  } else if (camera.fx <= 0 || camera.fy <= 0) {
    reason << "camera focal lengths must be positive, they are fx " << camera.fx << ", fy " << camera.fy
           << " (is the camera calibrated?)";
  } else if (!focalLengthFits(camera.fx, camera.width) || !focalLengthFits(camera.fy, camera.height)) {
    reason << "camera focal lengths fx " << camera.fx << ", fy " << camera.fy << " are no pixels of an image of "
           << camera.width << " x " << camera.height;
  } else if (std::abs(camera.cx) > kMaxPrincipalPointImages * camera.width ||
             std::abs(camera.cy) > kMaxPrincipalPointImages * camera.height) {
    reason << "camera principal point (" << camera.cx << ", " << camera.cy << ") is far outside the image of "
           << camera.width << " x " << camera.height;
  } else {
    return {};
  }
  return Status::error(StatusCode::kBadCamera, reason.str());
}

}  // namespace objectness

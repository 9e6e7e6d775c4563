// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "objectness_segmentation/scene/image_camera.hpp"

namespace objectness {

/// kBadCamera when the model or the number of its coefficients is not known, or one of them is no number.
Status validate(const LensDistortion& lens);

bool distorts(const LensDistortion& lens);

/// The farthest that the lens moves a pixel of the camera's view, pixels.
double largestShiftPx(const PinholeCamera& camera, const LensDistortion& lens);

/// Where a raw image shows what the pixels of the rectified one see, H x W, pixels; NaN where the lens model does not
/// reach. Both images are the camera's in size and intrinsics.
cv::Mat_<cv::Point2f> rawPixels(const PinholeCamera& camera, const LensDistortion& lens);

/// The rectified depth image in metres, 0 = none. raw: metres, CV_32F, not positive or not finite = none.
cv::Mat_<float> rectifyDepth(const cv::Mat_<float>& raw, const cv::Mat_<cv::Point2f>& raw_pixels);

/// The rectified picture, black where nothing is known.
cv::Mat rectifyColor(const cv::Mat& raw, const cv::Mat_<cv::Point2f>& raw_pixels);

}  // namespace objectness

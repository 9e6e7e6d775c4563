// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_segmentation {

/// The points of a cloud message: FLOAT32 x, y, z wherever its layout has them, and the colours of a packed rgb or rgba
/// field (FLOAT32 or UINT32) when there is one. Any field order, padding, point_step and row_step (0: rows follow one
/// another).
/// kBadInput: no such x, y, z; big-endian; steps and data size that contradict each other; no points.
/// step: only every so many-th row and column, from the first.
objectness::Result<objectness::RawCloud> toRawCloud(const sensor_msgs::PointCloud2& message, int step = 1);

/// The rectified camera of the images that carry this message: P, or K when P is not set; binning and region of
/// interest applied, as in image_geometry. kBadCamera: not calibrated (zeros), not finite, or without a size.
objectness::Result<objectness::PinholeCamera> toPinholeCamera(const sensor_msgs::CameraInfo& message);

/// The same of a depth image, with what the message says of its lens (objectness::imageCamera()).
objectness::Result<objectness::ImageCamera> toImageCamera(const sensor_msgs::CameraInfo& message);

/// A depth image of its own memory, REP 118: CV_16UC1 (millimetres, 0 = invalid) or CV_32FC1 (metres; NaN, infinite or
/// <= 0 = invalid). Either byte order, and without a step (0) when its rows follow one another. kBadInput: another
/// encoding, empty, step and data size that contradict each other.
objectness::Result<cv::Mat> toDepthImage(const sensor_msgs::Image& message);

/// Every so many-th row and column of an image, from the first; objectness::thinned() is the camera that sees these.
cv::Mat thinned(const cv::Mat& image, int step);

/// A picture as CV_8UC3 (BGR), of whatever encoding cv_bridge can convert. kBadInput otherwise.
objectness::Result<cv::Mat> toColorImage(const sensor_msgs::Image& message);

}  // namespace objectness_segmentation

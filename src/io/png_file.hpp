// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

enum class PngKind {
  kDepth,   ///< 16 bits, one channel: CV_16UC1
  kLabels,  ///< the same, but of labels
  kColor    ///< any picture: CV_8UC3, BGR
};

/// Reads a PNG file. It is checked from its signature to its last checksum before it is decoded, because libpng would
/// print its complaints about a damaged file by itself, and would allocate whatever size the header claims.
Result<cv::Mat> readPng(const std::string& path, PngKind kind);

/// Encodes CV_16UC1, CV_8UC1 or CV_8UC3 (BGR) and writes it as writeFile() does.
Status writePng(const std::string& path, const cv::Mat& image);

}  // namespace objectness

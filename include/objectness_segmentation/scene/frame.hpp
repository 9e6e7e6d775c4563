// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/camera.hpp"

namespace objectness {

/// One organized RGB-D view: the only input type of the core. Pixel (u, v) has index v * width + u everywhere.
/// Made by makeFrame(), which guarantees that sizes agree, that invalid points are NaN in all three coordinates, and that
/// small holes in a surface are bridged.
struct Frame {
  PinholeCamera camera;
  std::vector<Eigen::Vector3f> points;  ///< width * height, row-major, metres, optical frame, NaN = invalid
  cv::Mat_<cv::Vec3b> color;            ///< BGR, same size, or empty when the input carries no colour
  std::vector<int> bridged;  ///< ascending: pixels without depth whose points are interpolated (InputConfig::max_gap_px)
  /// What is unusual about the input without being in the way: sentences a user can act on.
  std::vector<std::string> remarks;

  int width() const { return camera.width; }
  int height() const { return camera.height; }
  int size() const { return camera.width * camera.height; }
};

/// A point cloud as it comes from a file or a message: organized (height > 1) or a list (height == 1).
struct RawCloud {
  int width = 0, height = 0;
  std::vector<Eigen::Vector3f> points;  ///< metres, optical frame; NaN or infinite = invalid
  std::vector<cv::Vec3b> colors;        ///< BGR per point, or empty
};

struct InputConfig {
  double min_depth_m = 0.15;
  double max_depth_m = 6.0;
  int max_gap_px = 2;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("min_depth_m", self.min_depth_m, Range{0.0, 5.0}, "points nearer than this (z) are invalid");
    visit("max_depth_m", self.max_depth_m, Range{0.1, 100.0}, "points farther than this (z) are invalid");
    visit("max_gap_px", self.max_gap_px, Range{0, 5},
          "of depth riddled with small holes, those of up to this many pixels in a row, column or diagonal are bridged "
          "where both sides are one surface; 0: none");
  }
};

/// Checks a cloud and puts it on its pixel grid.
/// - organized, with camera: sizes must agree.
/// - organized, no camera: intrinsics are recovered from the grid (recoverCamera()).
/// - a list, with camera: every point is projected to its pixel, the nearest one wins; kNotOrganized when fewer than
///   90 % of the points fall within half a pixel of a pixel centre's ray (the list is not a view of this camera).
/// - a list, no camera: kNotOrganized.
Result<Frame> makeFrame(const RawCloud& cloud, const std::optional<PinholeCamera>& camera, const InputConfig& config);

/// A frame from a depth image. depth: CV_16U (millimetres, 0 = invalid) or CV_32F (metres, non-finite or <= 0 =
/// invalid; REP 118). color: BGR of the same size, or empty.
Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const PinholeCamera& camera,
                        const InputConfig& config);

/// Least-squares pinhole intrinsics of an organized cloud: u = fx x/z + cx, v = fy y/z + cy over the valid points.
/// kBadCamera when there are too few points or the grid is no pinhole view (median residual over half a pixel).
Result<PinholeCamera> recoverCamera(const RawCloud& cloud);

}  // namespace objectness

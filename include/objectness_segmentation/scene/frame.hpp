// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/camera.hpp"
#include "objectness_segmentation/scene/image_camera.hpp"

namespace objectness {

/// One organized RGB-D view: the only input type of the core. Pixel (u, v) has index v * width + u everywhere.
/// Made by makeFrame(), which guarantees that sizes agree, that invalid points are NaN in all three coordinates, and
/// that small holes in a surface are bridged.
struct Frame {
  PinholeCamera camera;
  std::vector<Eigen::Vector3f> points;  ///< width * height, row-major, metres, optical frame, NaN = invalid
  cv::Mat_<cv::Vec3b> color;            ///< BGR, same size, or empty when the input carries no colour
  std::vector<int>
      bridged;  ///< ascending: pixels without depth whose points are interpolated (InputConfig::max_gap_px)
  /// What is unusual about the input without being in the way: sentences a user can act on.
  std::vector<std::string> remarks;
  bool rectified = false;  ///< the input was not: its pixels are not those of the frame

  int width() const { return camera.width; }
  int height() const { return camera.height; }
  int size() const { return camera.width * camera.height; }
};

/// A point cloud as it comes from a file or a message: organized (height > 1) or a list (height == 1).
struct RawCloud {
  int width = 0, height = 0;
  std::vector<Eigen::Vector3f> points;  ///< metres, optical frame; NaN or infinite = invalid
  std::vector<cv::Vec3b> colors;        ///< BGR per point, or empty
  std::string frame_id = {};            ///< what its source calls the frame of the points, for messages; or empty
  /// Pose of the sensor among the points, where its source tells one (VIEWPOINT of a PCD file).
  std::optional<Eigen::Isometry3d> T_cloud_sensor = {};
};

struct InputConfig {
  double min_depth_m = 0.15;
  double max_depth_m = 6.0;
  int max_gap_px = 2;
  double depth_unit_m = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("min_depth_m", self.min_depth_m, Range{0.0, 5.0}, "points nearer than this (z) are invalid");
    visit("max_depth_m", self.max_depth_m, Range{0.1, 100.0}, "points farther than this (z) are invalid");
    visit("max_gap_px", self.max_gap_px, Range{0, 5},
          "of depth riddled with small holes, those of up to this many pixels in a row, column or diagonal are bridged "
          "where both sides are one surface; 0: none");
    visit("depth_unit_m", self.depth_unit_m, Range{0.0, 0.02},
          "a unit of 16-bit depth images; 0: as the scene's camera.yaml says (depth_scale), else a millimetre");
  }
};

/// Checks a cloud and puts it on its pixel grid.
/// - organized, with camera: sizes must agree, or the camera's be a whole multiple (cameraOfSize()).
/// - organized, no camera: intrinsics are recovered from the grid (recoverCamera()).
/// - a list, with camera: every point is projected to its pixel, the nearest one wins; kNotOrganized when the
///   points do not lie on the camera's pixels, or when the cloud was down-sampled (averaged or thinned out).
/// - a list, no camera: kNotOrganized.
/// A cloud that is a view only from its T_cloud_sensor is moved there, with a remark.
Result<Frame> makeFrame(const RawCloud& cloud, const std::optional<PinholeCamera>& camera, const InputConfig& config);

/// A frame from a depth image. depth: CV_16U (InputConfig::depth_unit_m, 0 = invalid) or CV_32F (metres, non-finite or
/// <= 0 = invalid; REP 118). color: BGR of the same size, or empty. camera: of its size, or a whole multiple of it
/// (cameraOfSize()).
Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const PinholeCamera& camera,
                        const InputConfig& config);

/// The same of an image that need not be rectified: it is when the camera has a lens (the frame's pixels are then those
/// of the rectified image), with a remark.
Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const ImageCamera& camera,
                        const InputConfig& config);

}  // namespace objectness

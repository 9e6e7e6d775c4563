// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Frames that can be fused.
constexpr int kMostFused = 100;

struct DepthDifference;

/// What became of the pixels of one frame.
struct FusedDepth {
  bool restarted = false;    ///< first frame, other size, or the camera moved: the frame is as it came
  std::size_t averaged = 0;  ///< pixels whose depth is that of several frames
  std::size_t filled = 0;    ///< pixels without depth that have that of a frame before
  std::size_t changed = 0;   ///< pixels where the scene is not what it was
};

/// Averages depth over the last frames while the camera and what it sees stand still, a pixel at a time, over inverse
/// depth (the error of triangulating cameras has one size there).
///
/// - A pixel that deviates alone is an outlier: what was known stays, unless the next frames say the same. Where most
/// of
///   its neighbours deviate as well, or the mean around it has moved, the scene has changed, and the pixels start again
///   with the frame: a hand, or a thing that was moved, is seen at once.
/// - A hole keeps what was measured there in the last frames, unless all around it is a hole now, too.
/// - By how much depth varies while nothing moves is measured from frame to frame. What moves by less than three of
/// these
///   standard deviations cannot be distinguished from noise.
/// - Everything starts again when the camera moved: by its pose, or because depth changes everywhere, or by the same
/// over
///   whole parts of the picture.
///
/// Does not depend on the number of threads. Not thread safe.
class DepthFusion {
 public:
  /// frames: how many are averaged, up to kMostFused; 1: none.
  explicit DepthFusion(int frames);

  /// Replaces depths of the frame. Points stay on the rays of their pixels; a hole that is filled is no bridged pixel
  /// any more. T_fixed_camera: the camera in a frame that stands still, where it is known.
  FusedDepth fuse(const std::optional<Eigen::Isometry3d>& T_fixed_camera, int threads, Frame& frame);

  /// By pixel, of the last frame: how many frames its depth is of; 1 where the scene is new, 0 without depth.
  const cv::Mat_<uchar>& counts() const { return count_; }

  /// Forgets all frames.
  void clear();

  /// What is kept from frame to frame: 6 bytes a pixel.
  std::size_t memoryBytes() const;

 private:
  struct Change;
  bool isAnother(const Frame& frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera) const;
  void restart(const Frame& frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera);
  bool measureNoise(const DepthDifference& difference);
  bool hasChanged(const Change& change, int v, int u) const;
  FusedDepth fuseRow(const Change& change, int v, Frame& frame);

  int frames_;
  PinholeCamera camera_;
  std::optional<Eigen::Isometry3d> T_fixed_camera_;
  cv::Mat_<float> inverse_m_;  ///< inverse depth, 0: none
  cv::Mat_<uchar> count_;      ///< frames in it, up to frames_
  cv::Mat_<uchar> missed_;     ///< frames since the last measurement that agreed
  float sigma_ = 0;            ///< of the inverse depth of one frame; 0: not known yet
};

}  // namespace objectness

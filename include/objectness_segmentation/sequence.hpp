// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/tracking/depth_fusion.hpp"
#include "objectness_segmentation/tracking/tracker.hpp"

namespace objectness {

/// How many frames are fused where nothing else is said.
constexpr int kFuseFrames = 8;

/// What is found in one frame of a sequence.
struct SequenceResult {
  Frame frame;  ///< with fused depth: what was segmented
  Segmentation segmentation;
  std::vector<Identity> identities;  ///< of the segments; empty where objects are not tracked
  FusedDepth fused;
  double fusion_ms = 0, tracking_ms = 0;
};

/// The frames of one camera, one after the other. While camera and scene stand still the results do, too: depth is
/// fused (DepthFusion), and objects are known again (Tracker), whose boxes settle (TrackingConfig::settle_frames). Not
/// thread safe; deterministic.
class FrameSequence {
 public:
  /// fuse_frames: as in DepthFusion; 1: every frame for itself.
  explicit FrameSequence(int fuse_frames = kFuseFrames);
  ~FrameSequence();
  FrameSequence(FrameSequence&&) noexcept;
  FrameSequence& operator=(FrameSequence&&) noexcept;

  /// segment() of the frame that follows. T_fixed_camera: the camera in a frame in which the table stands still; none:
  /// not known, and whether the camera stands still is told by the picture. time_s: the frame's stamp; one a second or
  /// more before the last forgets everything first. model: nullptr for defaultModel().
  SequenceResult next(Frame frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera, double time_s,
                      const Config& config, const LearnedObjectness* model = nullptr,
                      const std::atomic<bool>* cancel = nullptr);

  /// What is kept of depth from frame to frame.
  std::size_t memoryBytes() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace objectness

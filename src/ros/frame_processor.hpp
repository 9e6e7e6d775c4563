// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <optional>

#include "objectness_segmentation/ros/segment_messages.hpp"
#include "ros/camera_poses.hpp"

namespace objectness_segmentation {

struct ProcessedFrame {
  SegmentedFrame result;                             ///< in the camera's frame
  std::optional<Eigen::Isometry3d> T_target_camera;  ///< where the outputs are to be moved to
  double transforms_ms = 0;
};

/// What is done with one frame: where was the camera, what is there, which objects are they. Remembers the
/// frames before. For one thread.
class FrameProcessor {
 public:
  FrameProcessor(const NodeSettings& settings, const ros::NodeHandle& nh)
      : poses_(settings, nh), sequence_(settings.fuse_frames), keep_memory_(settings.keep_memory) {}
  ~FrameProcessor();
  FrameProcessor(const FrameProcessor&) = delete;
  FrameProcessor& operator=(const FrameProcessor&) = delete;

  /// model: none for the built-in one. Does not throw for what is wrong with the messages.
  ProcessedFrame process(const InputMessages& messages, objectness::Config config,
                         const std::optional<objectness::LearnedObjectness>& model, const std::atomic<bool>& stop);

  /// Time went back: from any thread.
  void forgetTransforms() { poses_.clear(); }

 private:
  CameraPoses poses_;
  objectness::FrameSequence sequence_;
  const bool keep_memory_;
  bool keeps_memory_ = false;  ///< from the first frame on
};

}  // namespace objectness_segmentation

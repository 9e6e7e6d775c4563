// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/sequence.hpp"

namespace objectness_segmentation {

/// What came in together: a cloud, or a depth image and perhaps a picture.
struct InputMessages {
  sensor_msgs::PointCloud2ConstPtr cloud;
  sensor_msgs::CameraInfoConstPtr camera_info;  ///< may be null beside an organized cloud: recovered from its grid
  sensor_msgs::ImageConstPtr depth = nullptr;   ///< where there is no cloud
  sensor_msgs::ImageConstPtr color = nullptr;   ///< of the depth image's camera, or null

  /// Of what the result is about.
  const std_msgs::Header& header() const { return cloud ? cloud->header : depth->header; }
};

struct SegmentedFrame {
  objectness::Frame frame;  ///< empty when the messages are no frame
  objectness::Segmentation segmentation;
  std::vector<objectness::Identity> identities;  ///< of the segments; empty: by rank
  std::vector<std::string> remarks;              ///< what is wrong with the input without being in the way
  int input_width = 0, input_height = 0;         ///< of what came in
  int step = 1;                                  ///< the frame has every so many-th row and column of it
  double conversion_ms = 0;                      ///< time from messages to frame
  double fusion_ms = 0, tracking_ms = 0;
};

/// Inputs of more pixels than this are thinned out: they would only take longer.
constexpr std::int64_t kMaxPixels = 2100000;

/// From messages to a result: conversion, frame, core. Does not throw: what goes wrong, down to an exception of the
/// core (kInternalError) or of the system, is in segmentation.status. model: none for the built-in one.
SegmentedFrame segmentMessages(const InputMessages& messages, const objectness::Config& config,
                               const std::optional<objectness::LearnedObjectness>& model,
                               const std::atomic<bool>* cancel);

/// The same of messages that follow others; see FrameSequence for what is remembered.
SegmentedFrame segmentNext(const InputMessages& messages, const objectness::Config& config,
                           const std::optional<objectness::LearnedObjectness>& model, const std::atomic<bool>* cancel,
                           const std::optional<Eigen::Isometry3d>& T_fixed_camera, objectness::FrameSequence& sequence);

/// A result without frame that says why.
SegmentedFrame failedFrame(objectness::Status status);

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <optional>

#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/result.hpp"

namespace objectness_segmentation {

/// What came in together.
struct InputMessages {
  sensor_msgs::PointCloud2ConstPtr cloud;
  sensor_msgs::CameraInfoConstPtr camera_info;
};

struct SegmentedFrame {
  objectness::Frame frame;  ///< empty when the messages are no frame
  objectness::Segmentation segmentation;
};

/// From messages to a result: conversion, frame, core. Does not throw: what goes wrong, down to an exception of the
/// core (kInternalError) or of the system, is in segmentation.status. model: none for the built-in one.
SegmentedFrame segmentMessages(const InputMessages& messages, const objectness::Config& config,
                               const std::optional<objectness::LearnedObjectness>& model,
                               const std::atomic<bool>* cancel);

}  // namespace objectness_segmentation

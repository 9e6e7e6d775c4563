// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "objectness_segmentation/sequence.hpp"
#include "ros/synchronized_inputs.hpp"

namespace objectness_segmentation {

/// The nodelet's own parameters, read once at its start.
struct NodeSettings {
  InputSettings input;
  bool lazy = true;
  bool latch = false;
  bool keep_memory = true;                    ///< objectness::keepFrameMemory(): a setting of the whole process
  int fuse_frames = objectness::kFuseFrames;  ///< 1: none
  std::string model;
  std::string target_frame;          ///< of the outputs; empty: that of the input
  std::string up_frame;              ///< its z axis points against gravity; empty: not known
  std::string fixed_frame;           ///< in which the table stands still; empty: the camera does
  double transform_timeout_s = 0.1;  ///< longest wait for tf, wall time
  double service_timeout_s = 5;
};

/// Problems: a sentence for each parameter that could not be used; it has its default.
struct ReadSettings {
  NodeSettings settings;
  std::vector<std::string> problems;
};

ReadSettings readSettings(const ros::NodeHandle& nh);

/// Names below ~ that are no fields of the configuration: the nodelet's own, and those of what it is built from.
const std::vector<std::string>& settingNames();

}  // namespace objectness_segmentation

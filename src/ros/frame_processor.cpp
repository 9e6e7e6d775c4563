// SPDX-License-Identifier: BSD-3-Clause
#include "ros/frame_processor.hpp"

#include <chrono>
#include <utility>

#include "common/frame_memory.hpp"

namespace objectness_segmentation {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

void preferUp(const Eigen::Vector3d& up, objectness::TableConfig& table) {
  table.up_known = true;
  table.up_x = up.x();
  table.up_y = up.y();
  table.up_z = up.z();
}

}  // namespace

FrameProcessor::~FrameProcessor() {
  if (keeps_memory_) objectness::returnFrameMemory();
}

ProcessedFrame FrameProcessor::process(const InputMessages& messages, objectness::Config config,
                                       const std::optional<objectness::LearnedObjectness>& model,
                                       const std::atomic<bool>& stop) {
  if (keep_memory_ && !std::exchange(keeps_memory_, true)) objectness::keepFrameMemory();
  ProcessedFrame processed;
  const auto start = std::chrono::steady_clock::now();
  const CameraPose pose = poses_.at(messages.header(), stop);
  processed.transforms_ms = Milliseconds(std::chrono::steady_clock::now() - start).count();
  if (!pose.status.ok()) {
    processed.result = failedFrame(pose.status);
    return processed;
  }
  processed.T_target_camera = pose.T_target_camera;
  if (pose.up) preferUp(*pose.up, config.table);

  processed.result = segmentNext(messages, config, model, &stop, pose.T_fixed_camera, sequence_);
  if (!pose.remark.empty()) processed.result.remarks.push_back(pose.remark);
  return processed;
}

}  // namespace objectness_segmentation

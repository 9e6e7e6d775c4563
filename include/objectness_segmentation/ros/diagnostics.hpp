// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "objectness_segmentation/ros/frame_statistics.hpp"

namespace objectness_segmentation {

struct InputState {
  bool subscribed = false;
  std::size_t clouds_seen = 0, camera_infos_seen = 0;
  std::uint32_t dropped_frames = 0;
};

/// ERROR after an exception; WARN when input is awaited but does not come, or the last frame could not be segmented.
void describe(const FrameStatistics::Snapshot& snapshot, const InputState& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <optional>
#include <string>

#include "ros/frame_statistics.hpp"
#include "ros/input_state.hpp"

namespace objectness_segmentation {

/// ERROR after an exception; WARN when input is awaited but does not come or cannot be paired, when the last frame
/// could not be segmented, or when something about it is to be put right.
void describe(const FrameStatistics::Snapshot& snapshot, const InputState& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status);

/// What keeps frames from coming, and what to do about it.
std::string missingInput(const InputState& inputs);

/// The same, once frames have been awaited for long enough to say so.
std::optional<std::string> awaitedInput(const FrameStatistics::Snapshot& snapshot, const InputState& inputs);

/// That frames go on with a camera_info that did not come with them, and why.
std::string lastCameraUsed(const InputState& inputs);

}  // namespace objectness_segmentation

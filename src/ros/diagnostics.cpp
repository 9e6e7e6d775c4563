// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <string>

namespace objectness_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Without a frame for longer than this something is missing.
constexpr double kInputTimeout = 5.0;

std::string missingInput(const InputState& inputs) {
  if (inputs.clouds_seen == 0 && inputs.camera_infos_seen == 0) return "no messages on points and camera_info";
  if (inputs.clouds_seen == 0) return "no messages on points";
  if (inputs.camera_infos_seen == 0) return "no messages on camera_info";
  return "no pairs of points and camera_info with the same stamp: does ~approximate_sync help?";
}

}  // namespace

void describe(const FrameStatistics::Snapshot& snapshot, const InputState& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!snapshot.exception.empty()) {
    status.summary(DiagnosticStatus::ERROR, snapshot.exception);
  } else if (!inputs.subscribed) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes to an output");
  } else if (snapshot.seconds_since_input > kInputTimeout) {
    status.summary(DiagnosticStatus::WARN, missingInput(inputs));
  } else if (!snapshot.last_status.ok()) {
    status.summary(DiagnosticStatus::WARN, snapshot.last_status.message);
  } else {
    status.summary(DiagnosticStatus::OK, "segmenting");
  }
  status.addf("input rate [Hz]", "%.2f", snapshot.input_hz);
  status.addf("output rate [Hz]", "%.2f", snapshot.output_hz);
  status.addf("mean latency [ms]", "%.1f", snapshot.mean_latency_ms);
  status.addf("largest latency [ms]", "%.1f", snapshot.max_latency_ms);
  status.add("dropped frames", inputs.dropped_frames);
  status.add("points received", inputs.clouds_seen);
  status.add("camera_infos received", inputs.camera_infos_seen);
  status.add("last status", objectness::toString(snapshot.last_status.code));
  status.add("last number of objects", snapshot.last_objects);
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <sstream>
#include <string>

namespace objectness_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Without a frame for longer than this something is missing.
constexpr double kInputTimeout = 5.0;

std::string nothingOn(const std::string& topic, std::size_t publishers) {
  return "no messages on " + topic +
         (publishers == 0 ? ", which nobody publishes: remap it to the camera's topic" : "");
}

}  // namespace

std::string missingInput(const InputState& inputs) {
  if (inputs.frames > 0) return "no more frames on " + inputs.first_topic + " and " + inputs.camera_topic;
  if (inputs.first_seen == 0 && inputs.camera_infos_seen == 0) {
    return nothingOn(inputs.first_topic, inputs.first_publishers) + "; " +
           nothingOn(inputs.camera_topic, inputs.camera_publishers);
  }
  if (inputs.first_seen == 0) return nothingOn(inputs.first_topic, inputs.first_publishers);
  if (inputs.camera_infos_seen == 0) return nothingOn(inputs.camera_topic, inputs.camera_publishers);
  std::ostringstream text;
  text.precision(3);
  text << std::fixed << "no pairs of " << inputs.first_topic << " and " << inputs.camera_topic
       << " with the same stamp (the newest are of " << inputs.first_stamp.toSec() << " s and "
       << inputs.camera_stamp.toSec() << " s, " << inputs.first_stamp.toSec() - inputs.camera_stamp.toSec()
       << " s apart): does ~approximate_sync help?";
  return text.str();
}

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
  } else if (!snapshot.last_remark.empty()) {
    status.summary(DiagnosticStatus::WARN, snapshot.last_remark);
  } else {
    status.summary(DiagnosticStatus::OK, "segmenting");
  }
  status.addf("input rate [Hz]", "%.2f", snapshot.input_hz);
  status.addf("output rate [Hz]", "%.2f", snapshot.output_hz);
  status.addf("mean latency [ms]", "%.1f", snapshot.mean_latency_ms);
  status.addf("largest latency [ms]", "%.1f", snapshot.max_latency_ms);
  status.add("dropped frames", inputs.dropped_frames);
  status.add("points received", inputs.first_seen);
  status.add("camera_infos received", inputs.camera_infos_seen);
  status.add("last status", objectness::toString(snapshot.last_status.code));
  status.add("last number of objects", snapshot.last_objects);
  status.add("last boxes or groups scored", snapshot.last_boxes_scored);
  for (const auto& [stage, milliseconds] : snapshot.mean_stages_ms) {
    status.addf("mean " + stage + " [ms]", "%.1f", milliseconds);
  }
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#include "ros/diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <sstream>
#include <string>

#include "ros/frame_names.hpp"

namespace objectness_segmentation {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Without a frame for longer than this something is missing.
constexpr double kInputTimeout = 5.0;

std::string nothingOn(const std::string& topic, std::size_t publishers) {
  return "no messages on " + topic +
         (publishers == 0 ? ", which nobody publishes: remap it to the camera's topic" : "");
}

/// How far the newest stamps are apart.
std::string stampsOf(const InputState& inputs) {
  const double first_s = inputs.first_stamp.toSec(), camera_s = inputs.camera_stamp.toSec();
  std::ostringstream text;
  text.precision(3);
  text << std::fixed << "the newest are of " << first_s << " s and " << camera_s << " s, " << first_s - camera_s
       << " s apart";
  return text.str();
}

}  // namespace

std::string missingInput(const InputState& inputs) {
  const std::string &first = inputs.first_topic, &camera = inputs.camera_topic;
  if (inputs.frames > 0) return "no more frames on " + first + " and " + camera;
  if (inputs.first_seen == 0 && inputs.camera_infos_seen == 0) {
    return nothingOn(first, inputs.first_publishers) + "; " + nothingOn(camera, inputs.camera_publishers);
  }
  if (inputs.first_seen == 0) return nothingOn(first, inputs.first_publishers);
  if (inputs.camera_infos_seen == 0) return nothingOn(camera, inputs.camera_publishers);
  if (!mayBeSameFrame(inputs.first_frame, inputs.camera_frame)) {
    return "no pairs of " + first + " and " + camera + ": stamps are not the same (" + stampsOf(inputs) +
           "), nor is the frame_id (" + inputs.first_frame + " and " + inputs.camera_frame + "); remap " + camera +
           " to the camera of " + first + (inputs.approximate ? "" : ", or set ~approximate_sync where it is");
  }
  return "no pairs of " + first + " and " + camera + " with the same stamp (" + stampsOf(inputs) + ")" +
         (inputs.approximate ? "" : ": does ~approximate_sync help?");
}

std::string lastCameraUsed(const InputState& inputs) {
  return "messages on " + inputs.first_topic + " come without a camera_info of " +
         (inputs.approximate ? "about their stamp on " : "their stamp on ") + inputs.camera_topic + " (" +
         stampsOf(inputs) +
         "): the last one of their frame_id is used, which is right as long as the camera's resolution and region of "
         "interest do not change";
}

std::optional<std::string> awaitedInput(const FrameStatistics::Snapshot& snapshot, const InputState& inputs) {
  if (!inputs.subscribed || snapshot.seconds_since_input <= kInputTimeout) return std::nullopt;
  return missingInput(inputs);
}

void describe(const FrameStatistics::Snapshot& snapshot, const InputState& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!snapshot.exception.empty()) {
    status.summary(DiagnosticStatus::ERROR, snapshot.exception);
  } else if (!inputs.subscribed) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes to an output");
  } else if (const auto awaited = awaitedInput(snapshot, inputs)) {
    status.summary(DiagnosticStatus::WARN, *awaited);
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
  status.add("frames with the last camera_info", inputs.with_last_camera);
  status.add("last status", objectness::toString(snapshot.last_status.code));
  status.add("last number of objects", snapshot.last_objects);
  status.add("last boxes or groups scored", snapshot.last_boxes_scored);
  for (const auto& [stage, milliseconds] : snapshot.mean_stages_ms) {
    status.addf("mean " + stage + " [ms]", "%.1f", milliseconds);
  }
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
// The nodelet's results for every cloud or depth image of a bag: see `segment_bag --help`.
#include <csignal>
#include <cstdio>
#include <iostream>

#include "common/frame_memory.hpp"
#include "tools/segment_bag_options.hpp"
#include "tools/tool_message.hpp"

namespace {

using namespace objectness_segmentation;

enum ExitStatus { kAllDone = 0, kSomeFailed = 1, kUsageError = 2 };

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void printError(const std::string& message) { objectness::printToolMessage("segment_bag", message); }

void printFrame(const BagFrame& frame, const BagInput& input) {
  std::printf("%s %zu/%zu, stamp %u.%09u: ", input.frameName(), frame.number, input.frameCount(), frame.stamp.sec,
              frame.stamp.nsec);
  if (frame.status.ok()) {
    std::printf("%zu %s, %.0f ms\n", frame.objects, frame.objects == 1 ? "object" : "objects", frame.milliseconds);
  } else {
    std::printf("%s: %s\n", objectness::toString(frame.status.code), frame.status.message.c_str());
  }
  std::fflush(stdout);
}

void printTopics(const BagInput& input) {
  const InputTopics& topics = input.topics();
  std::printf("%ss %s", input.frameName(), topics.first().c_str());
  if (!topics.color.empty()) std::printf(", pictures %s", topics.color.c_str());
  std::printf(", camera %s\n", topics.camera_info.empty() ? "none" : topics.camera_info.c_str());
}

/// What the results are to be read with, as the nodelet warns of it.
void printRemarks(const SegmentBagReport& report, const SegmentBagOptions& options, const BagInput& input) {
  const InputTopics& topics = input.topics();
  const std::string of = std::string(" ") + input.frameName() + "(s) of " + topics.first() + " have no camera_info ";
  if (report.with_last_camera > 0) {
    printError(
        options.in + ": " + std::to_string(report.with_last_camera) + of + "of their stamp on " + topics.camera_info +
        ": the last one of their frame_id was taken, which is right as long as the camera's resolution and region "
        "of interest do not change; --approximate-sync takes the nearest");
  }
  if (report.without_camera > 0) {
    printError(options.in + ": " + std::to_string(report.without_camera) + of +
               (topics.camera_info.empty() ? "in this bag" : "of their stamp or frame_id on " + topics.camera_info) +
               (topics.ofDepth() ? "" : ": the camera was recovered from the grid of each"));
  }
  for (const auto& [remark, frames] : report.remarks) {
    printError(options.in + ": " + std::to_string(frames) + " " + input.frameName() + "(s): " + remark);
  }
}

ExitStatus run(const SegmentBagOptions& options) {
  const auto opened = BagInput::open(options.in, options.topics);
  if (!opened.ok()) {
    printError(options.in + ": " + opened.status.message);
    return kSomeFailed;
  }
  const BagInput& input = *opened.value;
  printTopics(input);

  BagOutput output(options.out);
  const SegmentBagReport report =
      segmentBag(input, options.settings, output, [&](const BagFrame& frame) { printFrame(frame, input); });
  const objectness::Status written = output.close();
  if (!report.status.ok()) printError(options.in + ": " + report.status.message);
  if (!written.ok()) printError("--out " + options.out + ": " + written.message);
  printRemarks(report, options, input);
  if (interrupted) printError("interrupted");
  std::printf("%zu of %zu %ss answered", report.answered, input.frameCount(), input.frameName());
  if (report.not_segmented > 0) std::printf(", %zu of them not segmented", report.not_segmented);
  std::printf(": %s\n", options.out.c_str());
  return report.answered == input.frameCount() && written.ok() ? kAllDone : kSomeFailed;
}

}  // namespace

int main(int argc, char** argv) {
  auto options = parseSegmentBagOptions(argc, argv);
  if (!options.ok()) {
    printError(options.status.message + " (segment_bag --help)");
    return kUsageError;
  }
  if (!options.value.print.empty()) {
    std::cout << options.value.print << std::flush;
    return std::cout ? kAllDone : kSomeFailed;
  }
  objectness::keepFrameMemory();
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
  options.value.settings.cancel = &interrupted;
  try {
    return run(options.value);
  } catch (const std::exception& e) {
    printError(options.value.in + ": " + e.what());
    return kSomeFailed;
  }
}

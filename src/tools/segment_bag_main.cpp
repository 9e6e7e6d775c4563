// SPDX-License-Identifier: BSD-3-Clause
// The nodelet's results for every cloud of a bag: see `segment_bag --help`.
#include <csignal>
#include <cstdio>
#include <iostream>

#include "objectness_segmentation/common/frame_memory.hpp"
#include "segment_bag_options.hpp"
#include "tool_message.hpp"

namespace {

using namespace objectness_segmentation;

enum ExitStatus { kAllDone = 0, kSomeFailed = 1, kUsageError = 2 };

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void printError(const std::string& message) { objectness::printToolMessage("segment_bag", message); }

void printFrame(const BagFrame& frame, std::size_t count) {
  std::printf("cloud %zu/%zu, stamp %u.%09u: ", frame.number, count, frame.stamp.sec, frame.stamp.nsec);
  if (frame.status.ok()) {
    std::printf("%zu %s, %.0f ms\n", frame.objects, frame.objects == 1 ? "object" : "objects", frame.milliseconds);
  } else {
    std::printf("%s: %s\n", objectness::toString(frame.status.code), frame.status.message.c_str());
  }
  std::fflush(stdout);
}

std::string missingCameras(const SegmentBagReport& report, const SegmentBagOptions& options,
                           const InputTopics& topics) {
  return options.in + ": " + std::to_string(report.without_camera) + " cloud(s) of " + topics.points +
         " have no camera_info of their stamp on " + topics.camera_info +
         " and got no result; --approximate-sync takes the nearest";
}

ExitStatus run(const SegmentBagOptions& options) {
  const auto input = BagInput::open(options.in, options.topics);
  if (!input.ok()) {
    printError(options.in + ": " + input.status.message);
    return kSomeFailed;
  }
  const InputTopics& topics = input.value->topics();
  const std::size_t count = input.value->cloudCount();
  std::printf("clouds %s, camera %s\n", topics.points.c_str(), topics.camera_info.c_str());

  BagOutput output(options.out);
  const SegmentBagReport report =
      segmentBag(*input.value, options.settings, output, [&](const BagFrame& frame) { printFrame(frame, count); });
  const objectness::Status written = output.close();
  if (!report.status.ok()) printError(options.in + ": " + report.status.message);
  if (!written.ok()) printError("--out " + options.out + ": " + written.message);
  if (report.without_camera > 0) printError(missingCameras(report, options, topics));
  if (interrupted) printError("interrupted");
  std::printf("%zu of %zu clouds answered", report.answered, count);
  if (report.not_segmented > 0) std::printf(", %zu of them not segmented", report.not_segmented);
  std::printf(": %s\n", options.out.c_str());
  return report.answered == count && written.ok() ? kAllDone : kSomeFailed;
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

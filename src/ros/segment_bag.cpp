// SPDX-License-Identifier: BSD-3-Clause
#include "ros/segment_bag.hpp"

#include <chrono>

#include "objectness_segmentation/ros/topics.hpp"
#include "ros/output_messages.hpp"

namespace objectness_segmentation {
namespace {

void write(const OutputMessages& messages, const ros::Time& time, BagOutput& output) {
  const std::string node = std::string("/") + kNodeName + "/";
  output.write(node + topics::kObjects, time, *messages.objects());
  output.write(node + topics::kSegments, time, *messages.segments());
  output.write(node + topics::kMarkers, time, *messages.markers());
}

void note(const std::string& remark, SegmentBagReport& report) {
  for (auto& [known, frames] : report.remarks) {
    if (known != remark) continue;
    ++frames;
    return;
  }
  if (report.remarks.size() < SegmentBagReport::kMaxRemarks) report.remarks.emplace_back(remark, 1);
}

}  // namespace

SegmentBagReport segmentBag(const BagInput& input, const SegmentBagSettings& settings, BagOutput& output,
                            const std::function<void(const BagFrame&)>& on_frame) {
  SegmentBagReport report;
  std::size_t number = 0;
  objectness::FrameSequence sequence(settings.fuse_frames);
  const auto answer = [&](const InputMessages& messages, const ros::Time& recorded) {
    ++number;
    const auto start = std::chrono::steady_clock::now();
    const SegmentedFrame result = segmentNext(messages, settings.config, settings.model, settings.cancel, {}, sequence);
    if (settings.cancel && *settings.cancel) return false;
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;

    const std_msgs::Header& header = messages.header();
    write(OutputMessages(result, header, {}), header.stamp.isZero() ? recorded : header.stamp, output);
    if (!output.status().ok()) return false;
    ++report.answered;
    const auto& camera = messages.camera_info;
    if (!camera) ++report.without_camera;
    if (camera && !settings.approximate_sync && camera->header.stamp != header.stamp) ++report.with_last_camera;
    // That there is no camera_info is counted already.
    for (const std::string& remark : result.segmentation.report.remarks) note(remark, report);
    const objectness::Status& status = result.segmentation.status;
    if (!status.ok()) ++report.not_segmented;
    on_frame({number, header.stamp, status, result.segmentation.segments.size(), elapsed.count()});
    return true;
  };
  report.status = input.forEachFrame(settings.approximate_sync, answer);
  return report;
}

}  // namespace objectness_segmentation

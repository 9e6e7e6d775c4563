// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/segment_messages.hpp"

#include <exception>
#include <string>
#include <utility>

#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {
namespace {

objectness::Result<objectness::Frame> toFrame(const InputMessages& messages, const objectness::InputConfig& config) {
  using Frame = objectness::Result<objectness::Frame>;
  const auto cloud = toRawCloud(*messages.cloud);
  if (!cloud.ok()) return Frame::error(cloud.status);
  const auto camera = toPinholeCamera(*messages.camera_info);
  if (!camera.ok()) return Frame::error(camera.status);
  return objectness::makeFrame(cloud.value, camera.value, config);
}

SegmentedFrame failure(const std::string& what) {
  SegmentedFrame result;
  result.segmentation.status = objectness::Status::error(objectness::StatusCode::kInternalError,
                                                         "the segmentation ended with an exception: " + what);
  return result;
}

}  // namespace

SegmentedFrame segmentMessages(const InputMessages& messages, const objectness::Config& config,
                               const std::optional<objectness::LearnedObjectness>& model,
                               const std::atomic<bool>* cancel) {
  try {
    SegmentedFrame result;
    auto frame = toFrame(messages, config.input);
    if (frame.ok()) {
      result.frame = std::move(frame.value);
      result.segmentation = model ? objectness::segment(result.frame, config, *model, cancel)
                                  : objectness::segment(result.frame, config, cancel);
    } else {
      result.segmentation.status = std::move(frame.status);
    }
    return result;
  } catch (const std::exception& e) {
    return failure(e.what());
  } catch (...) {
    return failure("of unknown type");
  }
}

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/segment_messages.hpp"

#include <chrono>
#include <exception>
#include <string>
#include <utility>

#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {
namespace {

using objectness::Result;
using objectness::Status;
using objectness::StatusCode;
using FrameResult = Result<objectness::Frame>;

FrameResult cloudFrame(const InputMessages& messages, const objectness::InputConfig& config,
                       std::vector<std::string>& remarks) {
  const auto cloud = toRawCloud(*messages.cloud);
  if (!cloud.ok()) return FrameResult::error(cloud.status);
  if (!messages.camera_info) {
    remarks.emplace_back(
        "there is no camera_info: the camera is recovered from the cloud's grid; publish camera_info, or remap it to "
        "the camera of the image that the cloud is made from");
    return objectness::makeFrame(cloud.value, std::nullopt, config);
  }
  const auto camera = toPinholeCamera(*messages.camera_info);
  return camera.ok() ? objectness::makeFrame(cloud.value, camera.value, config) : FrameResult::error(camera.status);
}

/// Colour is not needed: what is wrong with it is a remark.
cv::Mat usableColor(const InputMessages& messages, const cv::Size& size, std::vector<std::string>& remarks) {
  if (!messages.color) return {};
  const auto color = toColorImage(*messages.color);
  if (!color.ok()) {
    remarks.push_back(color.status.message + ": the results have no colour");
  } else if (color.value.size() != size) {
    remarks.push_back("the rgb image is " + std::to_string(color.value.cols) + " x " +
                      std::to_string(color.value.rows) + ", the depth image " + std::to_string(size.width) + " x " +
                      std::to_string(size.height) +
                      ": the results have no colour; remap rgb to the picture that is registered to depth");
  } else {
    return color.value;
  }
  return {};
}

FrameResult depthFrame(const InputMessages& messages, const objectness::InputConfig& config,
                       std::vector<std::string>& remarks) {
  const auto depth = toDepthImage(*messages.depth);
  if (!depth.ok()) return FrameResult::error(depth.status);
  if (!messages.camera_info) {
    return FrameResult::error(StatusCode::kBadCamera, "a depth image cannot be used without its camera_info");
  }
  const auto camera = toPinholeCamera(*messages.camera_info);
  if (!camera.ok()) return FrameResult::error(camera.status);
  return objectness::makeFrame(depth.value, usableColor(messages, depth.value.size(), remarks), camera.value, config);
}

SegmentedFrame failure(const std::string& what) {
  return failedFrame(Status::error(StatusCode::kInternalError, "the segmentation ended with an exception: " + what));
}

}  // namespace

SegmentedFrame failedFrame(Status status) {
  SegmentedFrame result;
  result.segmentation.status = std::move(status);
  return result;
}

SegmentedFrame segmentMessages(const InputMessages& messages, const objectness::Config& config,
                               const std::optional<objectness::LearnedObjectness>& model,
                               const std::atomic<bool>* cancel) {
  try {
    const auto start = std::chrono::steady_clock::now();
    SegmentedFrame result;
    auto frame = messages.cloud ? cloudFrame(messages, config.input, result.remarks)
                                : depthFrame(messages, config.input, result.remarks);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    result.conversion_ms = elapsed.count();
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

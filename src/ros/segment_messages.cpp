// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/segment_messages.hpp"

#include <chrono>
#include <cmath>
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

/// Sets how the input is thinned out. Sizes are not checked yet, and may be absurd.
void chooseStep(std::uint32_t width, std::uint32_t height, SegmentedFrame& result) {
  result.input_width = static_cast<int>(width);
  result.input_height = static_cast<int>(height);
  const double share = static_cast<double>(width) * height / static_cast<double>(kMaxPixels);
  if (share <= 1) return;
  result.step = static_cast<int>(std::ceil(std::sqrt(share)));
  result.remarks.push_back("the input is " + std::to_string(width) + " x " + std::to_string(height) +
                           ": of its rows and columns one in " + std::to_string(result.step) +
                           " is used; a smaller one costs less");
}

FrameResult cloudFrame(const InputMessages& messages, const objectness::InputConfig& config, SegmentedFrame& result) {
  const sensor_msgs::PointCloud2& message = *messages.cloud;
  const bool organized = message.height > 1;
  if (organized) chooseStep(message.width, message.height, result);
  const auto cloud = toRawCloud(message, result.step);
  if (!cloud.ok()) return FrameResult::error(cloud.status);
  if (!messages.camera_info) {
    result.remarks.emplace_back(
        "there is no camera_info of the cloud's stamp or frame_id: the camera is recovered from the cloud's grid; "
        "publish "
        "camera_info, or remap it to the camera of the image that the cloud is made from");
    return objectness::makeFrame(cloud.value, std::nullopt, config);
  }
  auto camera = toPinholeCamera(*messages.camera_info);
  if (!camera.ok()) return FrameResult::error(camera.status);
  if (!organized) {
    // The camera alone says how large the frame becomes.
    const std::int64_t pixels = static_cast<std::int64_t>(camera.value.width) * camera.value.height;
    if (pixels > kMaxPixels) {
      return FrameResult::error(StatusCode::kNotOrganized, "cloud is not organized, and a camera of " +
                                                               std::to_string(camera.value.width) + " x " +
                                                               std::to_string(camera.value.height) +
                                                               " pixels is too large to restore its grid");
    }
  } else if (camera.value.width == result.input_width && camera.value.height == result.input_height) {
    camera.value = thinned(camera.value, result.step);
  }
  return objectness::makeFrame(cloud.value, camera.value, config);
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

FrameResult depthFrame(const InputMessages& messages, const objectness::InputConfig& config, SegmentedFrame& result) {
  const auto depth = toDepthImage(*messages.depth);
  if (!depth.ok()) return FrameResult::error(depth.status);
  if (!messages.camera_info) {
    return FrameResult::error(
        StatusCode::kBadCamera,
        "there is no camera_info of the depth image's stamp or frame_id, and it cannot be used without: remap "
        "camera_info to its camera");
  }
  auto camera = toPinholeCamera(*messages.camera_info);
  if (!camera.ok()) return FrameResult::error(camera.status);
  const cv::Size size = depth.value.size();
  chooseStep(static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height), result);
  if (camera.value.width == size.width && camera.value.height == size.height) {
    camera.value = thinned(camera.value, result.step);
  }
  return objectness::makeFrame(thinned(depth.value, result.step),
                               thinned(usableColor(messages, size, result.remarks), result.step), camera.value, config);
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
    auto frame =
        messages.cloud ? cloudFrame(messages, config.input, result) : depthFrame(messages, config.input, result);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    result.conversion_ms = elapsed.count();
    if (frame.ok()) {
      result.frame = std::move(frame.value);
      result.segmentation = model ? objectness::segment(result.frame, config, *model, cancel)
                                  : objectness::segment(result.frame, config, cancel);
      const std::vector<std::string>& remarks = result.segmentation.report.remarks;
      result.remarks.insert(result.remarks.end(), remarks.begin(), remarks.end());
    } else {
      result.segmentation.status = std::move(frame.status);
      result.step = 1;
    }
    return result;
  } catch (const std::exception& e) {
    return failure(e.what());
  } catch (...) {
    return failure("of unknown type");
  }
}

}  // namespace objectness_segmentation

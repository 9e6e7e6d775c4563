// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/segment_messages.hpp"

#include <chrono>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

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

/// The camera of a cloud, which is as it is: no lens is taken out of it.
Result<objectness::PinholeCamera> cloudCamera(const sensor_msgs::CameraInfo& message,
                                              std::vector<std::string>& remarks) {
  auto camera = toPinholeCamera(message);
  if (!camera.ok()) return camera;
  const auto with_lens = toImageCamera(message);
  if (!with_lens.ok()) return camera;
  remarks.insert(remarks.end(), with_lens.value.remarks.begin(), with_lens.value.remarks.end());
  const std::string remark =
      with_lens.value.lens ? objectness::lensRemark(camera.value, *with_lens.value.lens) : std::string();
  if (!remark.empty()) remarks.push_back(remark);
  return camera;
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
  const auto camera = cloudCamera(*messages.camera_info, result.remarks);
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
    return objectness::makeFrame(cloud.value, camera.value, config);
  }
  if (result.step == 1) return objectness::makeFrame(cloud.value, camera.value, config);
  const auto sized =
      objectness::cameraOfSize(camera.value, result.input_width, result.input_height, "cloud", result.remarks);
  if (!sized.ok()) return FrameResult::error(sized.status);
  return objectness::makeFrame(cloud.value, thinned(sized.value, result.step), config);
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
  auto camera = toImageCamera(*messages.camera_info);
  if (!camera.ok()) return FrameResult::error(camera.status);
  const cv::Size size = depth.value.size();
  chooseStep(static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height), result);
  const auto sized =
      objectness::cameraOfSize(camera.value.pinhole, size.width, size.height, "depth image", camera.value.remarks);
  if (!sized.ok()) return FrameResult::error(sized.status);
  camera.value.pinhole = thinned(sized.value, result.step);
  return objectness::makeFrame(thinned(depth.value, result.step),
                               thinned(usableColor(messages, size, result.remarks), result.step), camera.value, config);
}

const objectness::LearnedObjectness* modelOf(const std::optional<objectness::LearnedObjectness>& model) {
  return model ? &*model : nullptr;
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

SegmentedFrame segmentNext(const InputMessages& messages, const objectness::Config& config,
                           const std::optional<objectness::LearnedObjectness>& model, const std::atomic<bool>* cancel,
                           const std::optional<Eigen::Isometry3d>& T_fixed_camera,
                           objectness::FrameSequence& sequence) {
  try {
    const auto start = std::chrono::steady_clock::now();
    SegmentedFrame result;
    auto frame =
        messages.cloud ? cloudFrame(messages, config.input, result) : depthFrame(messages, config.input, result);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    result.conversion_ms = elapsed.count();
    if (frame.ok()) {
      objectness::SequenceResult found = sequence.next(std::move(frame.value), T_fixed_camera,
                                                       messages.header().stamp.toSec(), config, modelOf(model), cancel);
      result.frame = std::move(found.frame);
      result.segmentation = std::move(found.segmentation);
      result.identities = std::move(found.identities);
      result.fusion_ms = found.fusion_ms;
      result.tracking_ms = found.tracking_ms;
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

SegmentedFrame segmentMessages(const InputMessages& messages, const objectness::Config& config,
                               const std::optional<objectness::LearnedObjectness>& model,
                               const std::atomic<bool>* cancel) {
  objectness::FrameSequence alone(1);
  objectness::Config untracked = config;
  untracked.tracking.enabled = false;
  return segmentNext(messages, untracked, model, cancel, {}, alone);
}

}  // namespace objectness_segmentation

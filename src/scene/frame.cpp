// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "bridged_gaps.hpp"
#include "organize.hpp"

namespace objectness {
namespace {

// An organized cloud whose points project this far from their own pixels was not taken by this camera.
constexpr double kMaxMedianMismatchPx = 3.0;
constexpr int kMismatchSamples = 5000;

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

/// NaN in all three coordinates outside the depth range, small holes bridged; kNoValidPoints when nothing is left.
Result<Frame> finish(Frame frame, const InputConfig& config) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  int finite = 0, valid = 0;
  for (Eigen::Vector3f& p : frame.points) {
    const bool is_finite = p.allFinite();
    finite += is_finite;
    if (is_finite && p.z() > 0 && p.z() >= config.min_depth_m && p.z() <= config.max_depth_m) {
      ++valid;
    } else {
      p.setConstant(nan);
    }
  }
  if (valid == 0) {
    std::ostringstream why;
    why << "none of the " << frame.points.size() << " pixels has a depth within " << config.min_depth_m << " and "
        << config.max_depth_m << " m (" << finite << " have any depth)";
    if (finite > 0) why << ": set input.min_depth_m and input.max_depth_m, or check the unit of the depth";
    return Result<Frame>::error(StatusCode::kNoValidPoints, why.str());
  }
  bridgeGaps(config.max_gap_px, frame);
  return {{}, std::move(frame)};
}

Status checkSizes(const RawCloud& cloud) {
  const long expected = static_cast<long>(cloud.width) * cloud.height;
  if (cloud.width < 0 || cloud.height < 0 || expected != static_cast<long>(cloud.points.size())) {
    return Status::error(StatusCode::kSizeMismatch, "cloud says it is " + sizeText(cloud.width, cloud.height) +
                                                        " but holds " + std::to_string(cloud.points.size()) +
                                                        " points");
  }
  if (!cloud.colors.empty() && cloud.colors.size() != cloud.points.size()) {
    return Status::error(StatusCode::kSizeMismatch, "cloud has " + std::to_string(cloud.points.size()) +
                                                        " points but " + std::to_string(cloud.colors.size()) +
                                                        " colours");
  }
  return {};
}

/// A wrong camera would quietly give wrong normals and boxes: compare it with the grid the points came on.
Status checkCameraFits(const RawCloud& cloud, const PinholeCamera& camera) {
  std::vector<float> mismatch;
  const std::size_t step = 1 + cloud.points.size() / kMismatchSamples;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    const Eigen::Vector3f& p = cloud.points[i];
    if (!p.allFinite() || p.z() <= 0) continue;
    const Eigen::Vector2d pixel(i % cloud.width, i / cloud.width);
    mismatch.push_back((camera.project(p.cast<double>()) - pixel).norm());
  }
  if (mismatch.empty()) return {};
  const auto median = mismatch.begin() + mismatch.size() / 2;
  std::nth_element(mismatch.begin(), median, mismatch.end());
  if (*median <= kMaxMedianMismatchPx) return {};
  std::ostringstream why;
  why << "the camera is not the one that took the cloud: points project " << *median
      << " px (median) from their own pixels; leave the camera out to recover it from the grid";
  return Status::error(StatusCode::kBadCamera, why.str());
}

}  // namespace

Result<Frame> makeFrame(const RawCloud& cloud, const std::optional<PinholeCamera>& camera, const InputConfig& config) {
  Status status = checkSizes(cloud);
  if (status.ok() && camera) status = validate(*camera);
  if (!status.ok()) return Result<Frame>::error(status);
  if (cloud.points.empty()) return Result<Frame>::error(StatusCode::kNoValidPoints, "cloud is empty");

  const bool organized = cloud.height > 1;
  if (!organized && !camera) {
    return Result<Frame>::error(StatusCode::kNotOrganized,
                                "cloud is " + sizeText(cloud.width, cloud.height) +
                                    ", not organized: give the camera that took it (--camera CAMERA.yaml)");
  }
  if (!organized && camera->height > 1) {
    Result<Frame> frame = organize(cloud, *camera);
    return frame.ok() ? finish(std::move(frame.value), config) : frame;
  }

  Frame frame;
  if (camera) {
    if (camera->width != cloud.width || camera->height != cloud.height) {
      return Result<Frame>::error(StatusCode::kSizeMismatch, "cloud is " + sizeText(cloud.width, cloud.height) +
                                                                 " but its camera is " +
                                                                 sizeText(camera->width, camera->height));
    }
    status = checkCameraFits(cloud, *camera);
    if (!status.ok()) return Result<Frame>::error(status);
    frame.camera = *camera;
  } else {
    const bool any_finite =
        std::any_of(cloud.points.begin(), cloud.points.end(), [](const auto& p) { return p.allFinite(); });
    if (any_finite) {
      const Result<PinholeCamera> recovered = recoverCamera(cloud);
      if (!recovered.ok()) return Result<Frame>::error(recovered.status);
      frame.camera = recovered.value;
    }
  }
  frame.points = cloud.points;
  if (!cloud.colors.empty()) {
    frame.color.create(cloud.height, cloud.width);
    std::copy(cloud.colors.begin(), cloud.colors.end(), frame.color.begin());
  }
  return finish(std::move(frame), config);
}

Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const PinholeCamera& camera,
                        const InputConfig& config) {
  if (depth.empty()) return Result<Frame>::error(StatusCode::kBadInput, "depth image is empty");
  if (depth.type() != CV_16UC1 && depth.type() != CV_32FC1) {
    return Result<Frame>::error(StatusCode::kBadInput,
                                "depth image must have one channel of 16-bit millimetres or 32-bit float metres");
  }
  if (!color.empty() && color.type() != CV_8UC3) {
    return Result<Frame>::error(StatusCode::kBadInput, "colour image must have three channels of 8 bits (BGR)");
  }
  const Status status = validate(camera);
  if (!status.ok()) return Result<Frame>::error(status);
  if (depth.cols != camera.width || depth.rows != camera.height) {
    return Result<Frame>::error(StatusCode::kSizeMismatch, "depth image is " + sizeText(depth.cols, depth.rows) +
                                                               " but its camera is " +
                                                               sizeText(camera.width, camera.height));
  }
  if (!color.empty() && color.size() != depth.size()) {
    return Result<Frame>::error(StatusCode::kSizeMismatch, "colour image is " + sizeText(color.cols, color.rows) +
                                                               " but the depth image is " +
                                                               sizeText(depth.cols, depth.rows));
  }

  Frame frame;
  frame.camera = camera;
  frame.points.resize(static_cast<std::size_t>(frame.size()));
  const bool millimetres = depth.type() == CV_16UC1;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u, ++i) {
      const float z = millimetres ? depth.at<ushort>(v, u) * 0.001f : depth.at<float>(v, u);
      frame.points[i] = z > 0 ? Eigen::Vector3f(camera.ray(u, v).cast<float>() * z) : Eigen::Vector3f(nan, nan, nan);
    }
  }
  if (!color.empty()) frame.color = color.clone();
  return finish(std::move(frame), config);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "common/upper_median.hpp"
#include "scene/bridged_gaps.hpp"
#include "scene/frame_axes.hpp"
#include "scene/lens.hpp"
#include "scene/organize.hpp"
#include "scene/recover_camera.hpp"

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
    if (finite > 0) {
      why << ": set input.min_depth_m and input.max_depth_m, or check the unit of the depth (--depth-scale, "
             "input.depth_unit_m)";
    }
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
  if (mismatch.empty()) {
    const std::string other_frame = otherFrameOf(cloud);
    return other_frame.empty() ? Status() : Status::error(StatusCode::kBadCamera, other_frame);
  }
  const double median = upperMedian(mismatch);
  if (median <= kMaxMedianMismatchPx) return {};
  std::ostringstream why;
  why << "the camera is not the one that took the cloud: points project " << median
      << " px (median) from their own pixels; ";
  const Result<PinholeCamera> own = recoverCamera(cloud);
  why << (own.ok() ? "leave the camera out to recover it from the grid" : own.status.message);
  return Status::error(StatusCode::kBadCamera, why.str());
}

/// The given camera, in the cloud's size.
Result<PinholeCamera> cameraOfCloud(const RawCloud& cloud, const PinholeCamera& given,
                                    std::vector<std::string>& remarks) {
  const Result<PinholeCamera> camera = cameraOfSize(given, cloud.width, cloud.height, "cloud", remarks);
  if (!camera.ok()) return camera;
  const Status fits = checkCameraFits(cloud, camera.value);
  if (fits.ok()) return camera;
  if (camera.value.width == given.width) return Result<PinholeCamera>::error(fits);
  // Whole multiples are no sign of thinning where the points do not agree.
  return Result<PinholeCamera>::error(StatusCode::kSizeMismatch, "cloud is " + sizeText(cloud.width, cloud.height) +
                                                                     " but its camera is " +
                                                                     sizeText(given.width, given.height) +
                                                                     ", and not thinned out from it: " + fits.message);
}

/// makeFrame() of a cloud as it is.
Result<Frame> frameOfCloud(const RawCloud& cloud, const std::optional<PinholeCamera>& camera,
                           const InputConfig& config) {
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
    const Result<PinholeCamera> fitting = cameraOfCloud(cloud, *camera, frame.remarks);
    if (!fitting.ok()) return Result<Frame>::error(fitting.status);
    frame.camera = fitting.value;
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

/// Metres of a unit of a 16-bit depth image: the configuration goes before what the camera's file says.
float unitOf(const ImageCamera& camera, const InputConfig& config) {
  constexpr double kMillimetre = 0.001;
  const double unit = config.depth_unit_m > 0 ? config.depth_unit_m : camera.depth_unit_m;
  return static_cast<float>(unit > 0 ? unit : kMillimetre);
}

/// depth: CV_16UC1 or CV_32FC1 (metres).
cv::Mat_<float> toMetres(const cv::Mat& depth, float unit_m) {
  if (depth.type() == CV_32FC1) return depth;
  cv::Mat_<float> metres(depth.size());
  std::transform(depth.begin<ushort>(), depth.end<ushort>(), metres.begin(),
                 [&](ushort value) { return value * unit_m; });
  return metres;
}

/// Rectifies the depth and the frame's colours.
void rectify(const LensDistortion& lens, cv::Mat_<float>& depth_m, Frame& frame) {
  const cv::Mat_<cv::Point2f> raw_pixels = rawPixels(frame.camera, lens);
  depth_m = rectifyDepth(depth_m, raw_pixels);
  if (!frame.color.empty()) frame.color = rectifyColor(frame.color, raw_pixels);
  frame.rectified = true;
  frame.remarks.emplace_back(
      "the camera has lens distortion and no projection matrix: the depth image was rectified, and the pixels of the "
      "results are those of the rectified image");
}

/// The cloud as its sensor sees it.
RawCloud seenFromSensor(const RawCloud& cloud) {
  RawCloud seen = cloud;
  const Eigen::Isometry3d T_sensor_cloud = cloud.T_cloud_sensor->inverse();
  for (Eigen::Vector3f& p : seen.points) p = (T_sensor_cloud * p.cast<double>()).cast<float>();
  return seen;
}

}  // namespace

Result<Frame> makeFrame(const RawCloud& cloud, const std::optional<PinholeCamera>& camera, const InputConfig& config) {
  Result<Frame> frame = frameOfCloud(cloud, camera, config);
  const bool no_view = frame.status.code == StatusCode::kBadCamera ||
                       (frame.status.code == StatusCode::kNotOrganized && camera.has_value());
  if (!no_view || !cloud.T_cloud_sensor) return frame;
  Result<Frame> moved = frameOfCloud(seenFromSensor(cloud), camera, config);
  if (moved.ok()) {
    moved.value.remarks.emplace_back(
        "the cloud is seen from its VIEWPOINT: results are in the camera's optical frame there, not in the cloud's");
    return moved;
  }
  frame.status.message += " (nor is it a view from its VIEWPOINT)";
  return frame;
}

Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const PinholeCamera& camera,
                        const InputConfig& config) {
  return makeFrame(depth, color, ImageCamera(camera), config);
}

Result<Frame> makeFrame(const cv::Mat& depth, const cv::Mat& color, const ImageCamera& image_camera,
                        const InputConfig& config) {
  if (depth.empty()) return Result<Frame>::error(StatusCode::kBadInput, "depth image is empty");
  if (depth.type() != CV_16UC1 && depth.type() != CV_32FC1) {
    return Result<Frame>::error(StatusCode::kBadInput,
                                "depth image must have one channel of 16-bit millimetres or 32-bit float metres");
  }
  if (!color.empty() && color.type() != CV_8UC3) {
    return Result<Frame>::error(StatusCode::kBadInput, "colour image must have three channels of 8 bits (BGR)");
  }
  Status status = validate(image_camera.pinhole);
  if (status.ok() && image_camera.lens) status = validate(*image_camera.lens);
  if (!status.ok()) return Result<Frame>::error(status);
  Frame frame;
  frame.remarks = image_camera.remarks;
  const Result<PinholeCamera> sized =
      cameraOfSize(image_camera.pinhole, depth.cols, depth.rows, "depth image", frame.remarks);
  if (!sized.ok()) return Result<Frame>::error(sized.status);
  const PinholeCamera& camera = frame.camera = sized.value;
  if (!color.empty() && color.size() != depth.size()) {
    return Result<Frame>::error(StatusCode::kSizeMismatch, "colour image is " + sizeText(color.cols, color.rows) +
                                                               " but the depth image is " +
                                                               sizeText(depth.cols, depth.rows));
  }

  cv::Mat_<float> depth_m = toMetres(depth, unitOf(image_camera, config));
  if (!color.empty()) frame.color = color.clone();
  if (image_camera.lens) rectify(*image_camera.lens, depth_m, frame);
  frame.points.resize(static_cast<std::size_t>(frame.size()));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u, ++i) {
      const float z = depth_m(v, u);
      frame.points[i] = z > 0 ? Eigen::Vector3f(camera.ray(u, v).cast<float>() * z) : Eigen::Vector3f(nan, nan, nan);
    }
  }
  return finish(std::move(frame), config);
}

}  // namespace objectness

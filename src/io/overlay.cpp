// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/overlay.hpp"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "common/color_palette.hpp"

namespace objectness {
namespace {

constexpr double kSegmentOpacity = 0.5;
constexpr double kNearPlane_m = 0.05;   // what lies nearer cannot be projected
constexpr int kReferenceWidthPx = 640;  // lines and letters grow with the image

cv::Vec3b bgr(std::size_t rank) {
  const Rgb color = objectColor(rank);
  return {color.b, color.g, color.r};
}

cv::Scalar toScalar(const cv::Vec3b& color) { return {double(color[0]), double(color[1]), double(color[2])}; }

/// Near is bright, missing is black; the range spans the central 98 % of the depths.
cv::Mat_<cv::Vec3b> renderDepth(const Frame& frame) {
  std::vector<float> depths;
  for (const auto& p : frame.points) {
    if (std::isfinite(p.z())) depths.push_back(p.z());
  }
  cv::Mat_<cv::Vec3b> image(frame.height(), frame.width(), cv::Vec3b(0, 0, 0));
  if (depths.empty()) return image;
  std::sort(depths.begin(), depths.end());
  const float nearest = depths[depths.size() / 100], farthest = depths[depths.size() - 1 - depths.size() / 100];
  for (int i = 0; i < frame.size(); ++i) {
    const float z = frame.points[i].z();
    if (!std::isfinite(z)) continue;
    const float closeness = std::clamp((farthest - z) / std::max(farthest - nearest, 1e-3f), 0.f, 1.f);
    const auto grey = cv::saturate_cast<uchar>(60 + 160 * closeness);
    image(i / frame.width(), i % frame.width()) = {grey, grey, grey};
  }
  return image;
}

void paintSegment(const Segment& segment, const cv::Vec3b& color, cv::Mat_<cv::Vec3b>& image) {
  cv::Mat_<uchar> mask(image.size(), uchar{0});
  for (const int i : segment.pixels) {
    cv::Vec3b& pixel = image(i / image.cols, i % image.cols);
    pixel = pixel * (1 - kSegmentOpacity) + color * kSegmentOpacity;
    mask(i / image.cols, i % image.cols) = 255;
  }
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(image, outlines, -1, toScalar(color), 1);
}

/// The part of a 3D line before the camera, on the image.
std::optional<std::pair<cv::Point, cv::Point>> projectLine(const PinholeCamera& camera, Eigen::Vector3d a,
                                                           Eigen::Vector3d b) {
  if (a.z() < kNearPlane_m && b.z() < kNearPlane_m) return {};
  for (Eigen::Vector3d* end : {&a, &b}) {
    const Eigen::Vector3d other = end == &a ? b : a;
    if (end->z() < kNearPlane_m) *end += (other - *end) * ((kNearPlane_m - end->z()) / (other.z() - end->z()));
  }
  const auto pixel = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d uv = camera.project(p);
    return cv::Point2l(std::lround(uv.x()), std::lround(uv.y()));
  };
  cv::Point2l from = pixel(a), to = pixel(b);
  if (!cv::clipLine(cv::Size2l(camera.width, camera.height), from, to)) return {};
  return std::make_pair(cv::Point(from), cv::Point(to));
}

void drawBox(const PinholeCamera& camera, const OrientedBox& box, const cv::Vec3b& color, int thickness,
             cv::Mat& image) {
  const Eigen::Vector3d eye = box.T_camera_box.inverse().translation(), half = 0.5 * box.size_m;
  // Edge: along `axis`, at the sides (-1 or 1) of the two other axes. It is hidden when neither of its faces is seen.
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (const int side2 : {-1, 1}) {
      for (const int side3 : {-1, 1}) {
        Eigen::Vector3d a, b;
        a[axis] = -half[axis];
        b[axis] = half[axis];
        a[second] = b[second] = side2 * half[second];
        a[third] = b[third] = side3 * half[third];
        const bool seen = side2 * eye[second] > half[second] || side3 * eye[third] > half[third];
        if (const auto line = projectLine(camera, box.T_camera_box * a, box.T_camera_box * b)) {
          cv::line(image, line->first, line->second, toScalar(color), seen ? 2 * thickness : thickness, cv::LINE_AA);
        }
      }
    }
  }
}

/// Of a thing without depth: magenta, as no object is.
void drawOutline(const PinholeCamera& camera, const Unmeasured& thing, int thickness, cv::Mat& image) {
  for (std::size_t k = 0; k < thing.outline.size(); ++k) {
    const auto line = projectLine(camera, thing.outline[k], thing.outline[(k + 1) % thing.outline.size()]);
    if (line) cv::line(image, line->first, line->second, {255, 0, 255}, 2 * thickness, cv::LINE_AA);
  }
}

void drawLabel(const Segment& segment, int label, double scale, cv::Mat& image) {
  if (segment.pixels.empty()) return;
  double u = 0, v = 0;
  for (const int i : segment.pixels) {
    u += i % image.cols;
    v += i / image.cols;
  }
  const double count = static_cast<double>(segment.pixels.size());
  const cv::Point at(static_cast<int>(u / count - 6 * scale), static_cast<int>(v / count + 6 * scale));
  const int thickness = std::max(1, static_cast<int>(scale));
  cv::putText(image, std::to_string(label), at, cv::FONT_HERSHEY_SIMPLEX, 0.5 * scale, {0, 0, 0}, 3 * thickness,
              cv::LINE_AA);
  cv::putText(image, std::to_string(label), at, cv::FONT_HERSHEY_SIMPLEX, 0.5 * scale, {255, 255, 255}, thickness,
              cv::LINE_AA);
}

}  // namespace

cv::Mat_<cv::Vec3b> drawOverlay(const Frame& frame, const Segmentation& result) {
  cv::Mat_<cv::Vec3b> image = frame.color.empty() ? renderDepth(frame) : cv::Mat_<cv::Vec3b>(frame.color.clone());
  const double scale = std::max(1.0, static_cast<double>(frame.width()) / kReferenceWidthPx);
  const int thickness = std::max(1, static_cast<int>(scale));
  for (std::size_t k = 0; k < result.segments.size(); ++k) paintSegment(result.segments[k], bgr(k), image);
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    drawBox(frame.camera, result.segments[k].box, bgr(k), thickness, image);
  }
  for (const Unmeasured& thing : result.unmeasured) drawOutline(frame.camera, thing, thickness, image);
  for (std::size_t k = 0; k < result.segments.size(); ++k)
    drawLabel(result.segments[k], static_cast<int>(k) + kFirstObjectLabel, scale, image);
  return image;
}

}  // namespace objectness

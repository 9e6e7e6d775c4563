// SPDX-License-Identifier: BSD-3-Clause
#include "segments/hole_explanations.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "scene/projector_shadow.hpp"

namespace objectness {
namespace {

constexpr double kAround = 0.5;  // of the hole's radius
constexpr int kMinAroundPx = 3;
constexpr double kMinTableAround = 0.4;  // of all pixels around
constexpr double kMostly = 0.5;          // of the hole
constexpr double kNearestM = 0.01;       // of a box's corners, for its picture

/// Adds the pixels of a hole in gaps of rows (or of columns) that may be shadows to `shadow`, of the mask's size.
void addShadows(const CompactHole& hole, const Frame& frame, bool columns, cv::Mat_<uchar>& shadow) {
  const int lines = columns ? hole.mask.cols : hole.mask.rows, length = columns ? hole.mask.rows : hole.mask.cols;
  const int first_line = columns ? hole.area.x : hole.area.y, first = columns ? hole.area.y : hole.area.x;
  const int end_of_picture = columns ? frame.height() : frame.width();
  const double focal = columns ? frame.camera.fy : frame.camera.fx;
  const auto depth = [&](int line, int at) {
    const int v = columns ? at : line, u = columns ? line : at;
    return frame.points[static_cast<std::size_t>(v) * frame.width() + u].z();
  };
  const auto pixel = [&](cv::Mat_<uchar>& image, int line, int at) -> uchar& {
    return columns ? image(at, line) : image(line, at);
  };
  cv::Mat_<uchar> mask = hole.mask;
  for (int line = 0; line < lines; ++line) {
    for (int at = 0; at < length; ++at) {
      if (!pixel(mask, line, at)) continue;
      int before = first + at - 1, after = first + at + 1;
      while (before >= 0 && !(depth(first_line + line, before) > 0)) --before;
      while (after < end_of_picture && !(depth(first_line + line, after) > 0)) ++after;
      const int end = std::min(length, after - first);
      if (before >= 0 && after < end_of_picture) {
        const float a = depth(first_line + line, before), b = depth(first_line + line, after);
        const bool may_be = after - before - 1 <= widestShadowPx(focal, std::min(a, b), std::max(a, b));
        for (int k = at; may_be && k < end; ++k) pixel(shadow, line, k) = 255;
      }
      at = end - 1;
    }
  }
}

std::vector<cv::Point> pictureOf(const OrientedBox& box, const PinholeCamera& camera) {
  std::vector<cv::Point> corners, picture;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d side((k & 1) - 0.5, ((k >> 1) & 1) - 0.5, ((k >> 2) & 1) - 0.5);
    const Eigen::Vector3d corner = box.T_camera_box * side.cwiseProduct(box.size_m);
    if (!(corner.z() > kNearestM)) return {};
    const Eigen::Vector2d pixel = camera.project(corner);
    corners.emplace_back(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
  }
  cv::convexHull(corners, picture);
  return picture;
}

}  // namespace

double tableAround(const CompactHole& hole, const cv::Mat_<ushort>& labels, const cv::Mat_<float>& height_m) {
  const int reach = std::max(kMinAroundPx, static_cast<int>(kAround * hole.radius_px));
  const cv::Rect area(hole.area.x - reach, hole.area.y - reach, hole.area.width + 2 * reach,
                      hole.area.height + 2 * reach);
  cv::Mat_<uchar> outside(area.size(), uchar(255));
  outside(cv::Rect({reach, reach}, hole.area.size())).setTo(0, hole.mask);
  cv::Mat_<float> distance;
  cv::distanceTransform(outside, distance, cv::DIST_L2, cv::DIST_MASK_5);
  int all = 0, table = 0, own = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      if (!outside(y, x) || distance(y, x) > reach) continue;
      ++all;
      const int v = area.y + y, u = area.x + x;
      if (u < 0 || v < 0 || u >= labels.cols || v >= labels.rows) continue;
      table += labels(v, u) == kTableLabel;
      own += labels(v, u) == 0 && height_m(v, u) > 0;
    }
  }
  return table < kMinTableAround * all ? std::nan("") : static_cast<double>(table) / (all - own);
}

bool isShadow(const CompactHole& hole, const Frame& frame) {
  cv::Mat_<uchar> shadow(hole.mask.size(), uchar(0));
  addShadows(hole, frame, false, shadow);
  addShadows(hole, frame, true, shadow);
  return cv::countNonZero(shadow & hole.mask) > kMostly * hole.pixels;
}

KnownThings::KnownThings(const PinholeCamera& camera, const std::vector<Segment>& segments) {
  for (const Segment& segment : segments) {
    std::vector<cv::Point> picture = pictureOf(segment.box, camera);
    if (!picture.empty()) pictures_.push_back(std::move(picture));
  }
}

bool KnownThings::hold(const CompactHole& hole) const {
  for (const std::vector<cv::Point>& picture : pictures_) {
    if ((cv::boundingRect(picture) & hole.area).empty()) continue;
    std::vector<cv::Point> moved;
    for (const cv::Point& corner : picture) moved.push_back(corner - hole.area.tl());
    cv::Mat_<uchar> covered(hole.mask.size(), uchar(0));
    cv::fillConvexPoly(covered, moved, cv::Scalar(255));
    if (cv::countNonZero(covered & hole.mask) > kMostly * hole.pixels) return true;
  }
  return false;
}

}  // namespace objectness

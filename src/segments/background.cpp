// SPDX-License-Identifier: BSD-3-Clause
#include "segments/background.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/share_below.hpp"
#include "scene/foot_height.hpp"
#include "scene/picture_margin.hpp"

namespace objectness {
namespace {

// Pixels at the picture's margin, in square roots of a segment's pixels: free of its size and of the resolution but for
// the margin's width.
constexpr double kLeaves = 0.5;
constexpr double kAlongMargin = 2.0;
constexpr double kMostlyOnTable = 0.6;  // a share of its points
constexpr double kSomeOnTable = 0.02;
constexpr double kTop = 0.97;   // share of its points that are not higher than the top
constexpr double kFoot = 0.03;  // the same of its foot
constexpr double kFeetInPicture = 0.9;
constexpr float kBendM = 0.02f;  // of a table, at the margin of the picture

/// Pixels at the picture's margin, in square roots of all.
double atMargin(const Segment& segment, const Frame& frame) {
  int pixels = 0;
  for (const int pixel : segment.pixels) {
    const int u = pixel % frame.width(), v = pixel / frame.width();
    pixels += pixelsToBorder(u, v, {frame.width(), frame.height()}) < kPictureMarginPx;
  }
  return pixels / std::sqrt(static_cast<double>(segment.pixels.size()));
}

/// Height over the table that a share of the segment's points is under.
float heightBelow(double share, const Segment& segment, const ObjectPoints& above) {
  std::vector<float> heights;
  heights.reserve(segment.pixels.size());
  for (const int pixel : segment.pixels) {
    heights.push_back(above.height_m(pixel / above.height_m.cols, pixel % above.height_m.cols));
  }
  return shareBelow(share, heights);
}

/// Share of the segment's points whose places on the table's plane are in the picture.
double feetInPicture(const Segment& segment, const Frame& frame, const Table& table) {
  int in_picture = 0;
  for (const int pixel : segment.pixels) {
    const Eigen::Vector3d p = frame.points[pixel].cast<double>();
    const Eigen::Vector3d foot = p - table.height(frame.points[pixel]) * table.normal;
    if (!(foot.z() > 0)) continue;
    const Eigen::Vector2d at = frame.camera.project(foot);
    const cv::Size picture(frame.width(), frame.height());
    in_picture += pixelsToBorder(at.x(), at.y(), picture) >= kPictureMarginPx;
  }
  return in_picture / static_cast<double>(segment.pixels.size());
}

bool isBesideTable(const Segment& segment, const Frame& frame, const Table& table, const ObjectPoints& above) {
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  int on_table = 0, by_table = 0;
  for (const int pixel : segment.pixels) {
    const Eigen::Vector3f p = T_table_camera * frame.points[pixel];
    const uchar cell = table.extent.at(p.x(), p.y());
    on_table += cell == TableExtent::kCore;
    by_table += cell >= TableExtent::kMargin;
  }
  const double pixels = static_cast<double>(segment.pixels.size());
  const bool over_the_edge = on_table > kSomeOnTable * pixels && on_table < kMostlyOnTable * pixels;
  // What stands behind others at the picture's end has its whole foot where the table is hidden: that says nothing.
  const bool hangs = on_table <= kSomeOnTable * pixels && heightBelow(kFoot, segment, above) > kFootHeightM &&
                     feetInPicture(segment, frame, table) > kFeetInPicture;
  return over_the_edge || hangs || by_table < kMostlyOnTable * pixels;
}

bool isBackground(const Segment& segment, const Frame& frame, const Table& table, const ObjectPoints& above) {
  const double at_margin = atMargin(segment, frame);
  if (!(at_margin > kLeaves)) return false;
  return isBesideTable(segment, frame, table, above) ||
         (at_margin > kAlongMargin && heightBelow(kTop, segment, above) < kBendM);
}

}  // namespace

std::vector<Segment> takeBackground(const Frame& frame, const Table& table, const ObjectPoints& above,
                                    std::vector<Segment>& segments) {
  std::vector<Segment> background;
  const auto rest = std::stable_partition(segments.begin(), segments.end(), [&](const Segment& segment) {
    return segment.pixels.empty() || !isBackground(segment, frame, table, above);
  });
  std::move(rest, segments.end(), std::back_inserter(background));
  segments.erase(rest, segments.end());
  return background;
}

}  // namespace objectness

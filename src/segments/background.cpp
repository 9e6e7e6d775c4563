// SPDX-License-Identifier: BSD-3-Clause
#include "segments/background.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/share_below.hpp"

namespace objectness {
namespace {

constexpr int kMarginPx = 3;  // cameras often have no depth in the outermost pixels
// Pixels at the picture's margin, in square roots of a segment's pixels: free of its size and of the resolution but for
// the margin's width.
constexpr double kLeaves = 0.5;
constexpr double kAlongMargin = 2.0;
constexpr double kMostlyOnTable = 0.6;  // a share of its points
constexpr double kSomeOnTable = 0.02;
constexpr double kTop = 0.97;    // share of its points that are not higher than the top
constexpr float kBendM = 0.02f;  // of a table, at the margin of the picture

/// Pixels at the picture's margin, in square roots of all.
double atMargin(const Segment& segment, const Frame& frame) {
  int pixels = 0;
  for (const int pixel : segment.pixels) {
    const int u = pixel % frame.width(), v = pixel / frame.width();
    pixels += std::min({u, v, frame.width() - 1 - u, frame.height() - 1 - v}) < kMarginPx;
  }
  return pixels / std::sqrt(static_cast<double>(segment.pixels.size()));
}

bool isBesideTable(const Segment& segment, const Frame& frame, const Table& table) {
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  int on_table = 0, by_table = 0;
  for (const int pixel : segment.pixels) {
    const Eigen::Vector3f p = T_table_camera * frame.points[pixel];
    const uchar cell = table.extent.at(p.x(), p.y());
    on_table += cell == 255;
    by_table += cell != 0;
  }
  const double pixels = static_cast<double>(segment.pixels.size());
  // What stands behind others at the picture's end has its whole foot where the table is hidden: that says nothing.
  const bool over_the_edge = on_table > kSomeOnTable * pixels && on_table < kMostlyOnTable * pixels;
  return over_the_edge || by_table < kMostlyOnTable * pixels;
}

float topOf(const Segment& segment, const ObjectPoints& above) {
  std::vector<float> heights;
  for (const int pixel : segment.pixels)
    heights.push_back(above.height_m(pixel / above.height_m.cols, pixel % above.height_m.cols));
  return shareBelow(kTop, heights);
}

bool isBackground(const Segment& segment, const Frame& frame, const Table& table, const ObjectPoints& above) {
  const double at_margin = atMargin(segment, frame);
  if (!(at_margin > kLeaves)) return false;
  return isBesideTable(segment, frame, table) || (at_margin > kAlongMargin && topOf(segment, above) < kBendM);
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

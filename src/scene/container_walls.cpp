// SPDX-License-Identifier: BSD-3-Clause
#include "scene/container_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "common/angles.hpp"
#include "common/share_below.hpp"

namespace objectness {
namespace {

constexpr float kCellM = 0.004f;
constexpr int kDirections = 48;
constexpr float kMinReachM = 0.06f, kReach = 0.4f;  // how far outside the floor a wall is looked for; of its radius
constexpr float kMinWallM = 0.008f;
constexpr double kMinKnown = 0.5;   // of all directions: the others leave the picture
constexpr double kMinWalls = 0.75;  // of the known
constexpr double kMinEqual = 0.6;   // of the known, within kEqual of the median height
constexpr float kEqual = 0.35f, kEqualM = 0.006f;
constexpr float kUnseen = -std::numeric_limits<float>::infinity();

cv::Point2f centreOf(const std::vector<cv::Point2f>& outline) {
  const cv::Moments moments = cv::moments(outline);
  return {static_cast<float>(moments.m10 / moments.m00), static_cast<float>(moments.m01 / moments.m00)};
}

/// How far it is from a place inside a convex outline to the outline.
float reachOf(const std::vector<cv::Point2f>& outline, const cv::Point2f& from, const cv::Point2f& direction) {
  float reach = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const cv::Point2f a = outline[i] - from, side = outline[(i + 1) % outline.size()] - outline[i];
    const float across = static_cast<float>(direction.cross(side));
    const float t = static_cast<float>(a.cross(side)) / across;
    if (across != 0 && t > 0) reach = std::min(reach, t);  // of a convex outline the first line that is met
  }
  return reach;
}

/// A plan of an outline and of what is `around_m` around it.
struct Plan {
  cv::Point2f origin;
  cv::Size cells;

  Plan(const std::vector<cv::Point2f>& outline, float around_m) {
    cv::Point2f low = outline.front(), high = low;
    for (const auto& p : outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const cv::Point2f around(around_m, around_m), size = high - low + 2 * around;
    origin = low - around;
    cells = {1 + cvFloor(size.x / kCellM), 1 + cvFloor(size.y / kCellM)};
  }
  cv::Point2f inCells(const cv::Point2f& place) const { return (place - origin) / kCellM; }
  /// Compared before it is rounded: what lies far behind does not fit into a whole number.
  bool holds(const cv::Point2f& place) const {
    const cv::Point2f p = inCells(place);
    return p.x >= 0 && p.y >= 0 && p.x < static_cast<float>(cells.width) && p.y < static_cast<float>(cells.height);
  }
  cv::Point cellOf(const cv::Point2f& place) const {
    const cv::Point2f p = inCells(place);
    return {cvFloor(p.x), cvFloor(p.y)};
  }
};

}  // namespace

std::optional<double> wallHeight(const std::vector<cv::Point2f>& outline, const std::vector<cv::Point2f>& places,
                                 const std::vector<float>& over_floor_m, float noise_m) {
  const cv::Point2f centre = centreOf(outline);
  float farthest = 0;
  for (const auto& corner : outline) farthest = std::max(farthest, static_cast<float>(cv::norm(corner - centre)));
  const Plan plan(outline, std::max(kMinReachM, kReach * farthest));
  cv::Mat_<float> highest(plan.cells, kUnseen);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!plan.holds(places[i])) continue;
    float& cell = highest(plan.cellOf(places[i]));
    cell = std::max(cell, over_floor_m[i]);
  }
  std::vector<float> heights, walls;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * kPi * k / kDirections;
    const cv::Point2f direction(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    const float reach = std::min(farthest, reachOf(outline, centre, direction));
    float height = kUnseen;
    for (float at = reach - kCellM; at < reach + std::max(kMinReachM, kReach * reach); at += kCellM / 2) {
      const cv::Point2f place = centre + at * direction;
      if (plan.holds(place)) height = std::max(height, highest(plan.cellOf(place)));
    }
    if (height == kUnseen) continue;
    heights.push_back(height);
    if (height > std::max(kMinWallM, 2 * noise_m)) walls.push_back(height);
  }
  const double known = static_cast<double>(heights.size());
  if (known < kMinKnown * kDirections || walls.size() < kMinWalls * known) return {};
  const float wall = shareBelow(0.5, walls), margin = static_cast<float>(highestWall(wall)) - wall;
  const auto equal =
      std::count_if(heights.begin(), heights.end(), [&](float h) { return std::abs(h - wall) < margin; });
  if (static_cast<double>(equal) < kMinEqual * known) return {};
  return wall;
}

double highestWall(double wall_height_m) {
  return wall_height_m + std::max(kEqual * wall_height_m, static_cast<double>(kEqualM));
}

}  // namespace objectness

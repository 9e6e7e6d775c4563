// SPDX-License-Identifier: BSD-3-Clause
#include "container_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "../common/share_below.hpp"
#include "objectness_segmentation/common/angles.hpp"

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

/// The highest point in each cell of a plan, in and around an outline.
class HighestInCells {
 public:
  HighestInCells(const std::vector<cv::Point2f>& outline, float around_m, const std::vector<cv::Point2f>& places,
                 const std::vector<float>& over_floor_m) {
    cv::Point2f high = origin_ = outline.front();
    for (const auto& p : outline) {
      origin_ = {std::min(origin_.x, p.x), std::min(origin_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    origin_ -= cv::Point2f(around_m, around_m);
    const cv::Point2f size = high - origin_ + cv::Point2f(around_m, around_m);
    cells_ = cv::Mat_<float>(1 + cvFloor(size.y / kCellM), 1 + cvFloor(size.x / kCellM), kUnseen);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const cv::Point2f in_cells = (places[i] - origin_) / kCellM;
      // Compared as they are: what lies far behind would not fit into a whole number.
      if (!(in_cells.x >= 0 && in_cells.y >= 0 && in_cells.x < cells_.cols && in_cells.y < cells_.rows)) continue;
      float& cell = cells_(cellOf(places[i]));
      cell = std::max(cell, over_floor_m[i]);
    }
  }

  float at(const cv::Point2f& place) const {
    const cv::Point cell = cellOf(place);
    return cv::Rect({}, cells_.size()).contains(cell) ? cells_(cell) : kUnseen;
  }

 private:
  cv::Point cellOf(const cv::Point2f& place) const {
    return {cvFloor((place.x - origin_.x) / kCellM), cvFloor((place.y - origin_.y) / kCellM)};
  }

  cv::Mat_<float> cells_;
  cv::Point2f origin_;
};

}  // namespace

FloorArea::FloorArea(const std::vector<cv::Point2f>& outline, double margin_m) {
  cv::Point2f high = origin_ = outline.front();
  for (const auto& p : outline) {
    origin_ = {std::min(origin_.x, p.x), std::min(origin_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const cv::Point2f size = high - origin_;
  cells_ = cv::Mat_<uchar>::zeros(1 + cvFloor(size.y / kCellM), 1 + cvFloor(size.x / kCellM));
  std::vector<cv::Point> corners;
  for (const auto& p : outline)
    corners.emplace_back(cvFloor((p.x - origin_.x) / kCellM), cvFloor((p.y - origin_.y) / kCellM));
  cv::fillConvexPoly(cells_, corners, cv::Scalar(255));
  cv::copyMakeBorder(cells_, cells_, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  origin_ -= cv::Point2f(kCellM, kCellM);
  const int margin = 2 * static_cast<int>(std::ceil(margin_m / kCellM)) + 1;
  cv::erode(cells_, cells_, cv::Mat::ones(margin, margin, CV_8U));
}

bool FloorArea::contains(const cv::Point2f& place) const {
  const cv::Point2f in_cells = (place - origin_) / kCellM;
  if (!(in_cells.x >= 0 && in_cells.y >= 0 && in_cells.x < cells_.cols && in_cells.y < cells_.rows)) return false;
  return cells_(static_cast<int>(in_cells.y), static_cast<int>(in_cells.x)) != 0;
}

std::optional<double> wallHeight(const std::vector<cv::Point2f>& outline, const std::vector<cv::Point2f>& places,
                                 const std::vector<float>& over_floor_m, float noise_m) {
  const cv::Point2f centre = centreOf(outline);
  float farthest = 0;
  for (const auto& corner : outline) farthest = std::max(farthest, static_cast<float>(cv::norm(corner - centre)));
  const HighestInCells highest(outline, std::max(kMinReachM, kReach * farthest), places, over_floor_m);
  std::vector<float> heights, walls;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * kPi * k / kDirections;
    const cv::Point2f direction(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    const float reach = std::min(farthest, reachOf(outline, centre, direction));
    float height = kUnseen;
    for (float at = reach - kCellM; at < reach + std::max(kMinReachM, kReach * reach); at += kCellM / 2) {
      height = std::max(height, highest.at(centre + at * direction));
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

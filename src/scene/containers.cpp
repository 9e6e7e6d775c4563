// SPDX-License-Identifier: BSD-3-Clause
#include "scene/containers.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "common/angles.hpp"
#include "common/convex_area.hpp"
#include "common/share_below.hpp"
#include "scene/connected_components_2d.hpp"
#include "scene/container_walls.hpp"

namespace objectness {
namespace {

constexpr double kMinFloorM2 = 0.03;                   // a disc of 20 cm: plates and bowls have smaller floors
constexpr float kMaxFloorM = 2;                        // the floor of a room is none
constexpr double kBridgeM = 0.006;                     // of a wall that depth has holes in
constexpr float kLevelCosine = 0.966f;                 // 15 deg
constexpr double kMaxTiltDeg = 8;                      // of the floor against the table
constexpr float kDeepestM = -0.02f, kHighestM = 0.2f;  // where floors are looked for, over the table
constexpr float kMinLayerM = 0.002f;                   // step of the histogram of heights
constexpr double kMinLayerShare = 0.12;                // of what the walls enclose, in the floor
constexpr int kFits = 4;
constexpr double kMinContents = 0.05;  // share of what is seen over the floor
constexpr int kMinPixels = 200;
constexpr float kFootM = 0.004f;                        // of a wall: no part of the floor
constexpr float kNearWallM = 0.012f, kNearWall = 0.3f;  // upright walls are seen this far over it; of their height
constexpr float kSteepCosine = 0.7f;
constexpr double kRectangular = 0.85;    // share of the rectangle around a floor; a round one fills 0.79
constexpr double kMinPatchShare = 0.03;  // of the floor; smaller patches of its plane may be anything

/// A connected part with what it encloses in the picture.
struct Enclosed {
  cv::Rect box;
  std::vector<int> pixels;  ///< with depth
};

std::vector<Enclosed> enclosedParts(const Frame& frame, const cv::Mat_<uchar>& mask) {
  std::vector<Enclosed> found;
  if (cv::countNonZero(mask) == 0) return found;
  const double focal = frame.camera.focal();
  std::vector<float> depths;
  for (int i = 0; i < frame.size(); i += 16) {
    if (mask(i / mask.cols, i % mask.cols) && frame.points[i].z() > 0) depths.push_back(frame.points[i].z());
  }
  if (depths.empty()) return found;
  const double metres_per_px = shareBelow(0.5, depths) / focal;
  const int bridge_px = std::max(3, static_cast<int>(kBridgeM / metres_per_px) | 1);
  cv::Mat_<uchar> closed;
  cv::morphologyEx(mask, closed, cv::MORPH_CLOSE, cv::Mat::ones(bridge_px, bridge_px, CV_8U));
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(closed, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  for (const auto& outline : outlines) {
    const cv::Rect box = cv::boundingRect(outline);
    if (box.area() * metres_per_px * metres_per_px < kMinFloorM2) continue;
    cv::Mat_<uchar> filled(box.size(), uchar(0));
    cv::drawContours(filled, std::vector<std::vector<cv::Point>>{outline}, 0, cv::Scalar(255), cv::FILLED, cv::LINE_8,
                     {}, 0, -box.tl());
    Enclosed part{box, {}};
    for (int v = 0; v < box.height; ++v) {
      for (int u = 0; u < box.width; ++u) {
        const int i = (box.y + v) * mask.cols + box.x + u;
        if (filled(v, u) && frame.points[i].z() > 0) part.pixels.push_back(i);
      }
    }
    found.push_back(std::move(part));
  }
  // From the first row down, as everything else is numbered; OpenCV's versions differ in their order.
  std::sort(found.begin(), found.end(), [](const Enclosed& a, const Enclosed& b) {
    return std::pair(a.box.y, a.box.x) < std::pair(b.box.y, b.box.x);
  });
  return found;
}

/// Height of the lowest level layer that holds a good part of the pixels.
std::optional<float> lowestLayer(const std::vector<float>& level_m, std::size_t enclosed, float step_m) {
  std::vector<int> counts(static_cast<std::size_t>((kHighestM - kDeepestM) / step_m) + 3, 0);
  for (const float h : level_m) {
    if (h > kDeepestM && h < kHighestM) ++counts[1 + static_cast<std::size_t>((h - kDeepestM) / step_m)];
  }
  const auto around = [&](std::size_t k) { return counts[k - 1] + counts[k] + counts[k + 1]; };
  for (std::size_t k = 1; k + 1 < counts.size(); ++k) {
    if (around(k) < kMinLayerShare * static_cast<double>(enclosed)) continue;
    while (k + 2 < counts.size() && around(k + 1) > around(k)) ++k;
    return kDeepestM + (static_cast<float>(k) - 0.5f) * step_m;
  }
  return {};
}

/// The floor's plane and the places where it is seen.
class FloorFinder {
 public:
  FloorFinder(const Frame& frame, const Normals& normals, const Table& table, const HeightMap& map,
              const Enclosed& part)
      : part_(part), map_(map), width_(frame.width()) {
    const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
    const Eigen::Vector3f up = table.normal.cast<float>();
    for (const int pixel : part.pixels) {
      const Eigen::Vector3f place = T_table_camera * frame.points[pixel];
      places_.push_back({place.x(), place.y()});
      level_.push_back(normals.radius_px[pixel] > 0 && normals.normal[pixel].dot(up) > kLevelCosine);
    }
  }

  const std::vector<cv::Point2f>& places() const { return places_; }

  bool find(Container& container) const {
    std::vector<float> heights, thresholds;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!level_[i]) continue;
      heights.push_back(height(i));
      thresholds.push_back(threshold(i));
    }
    if (heights.size() < kMinPixels) return false;
    const float step_m = std::max(kMinLayerM, shareBelow(0.5, thresholds) / 3);
    const auto layer = lowestLayer(heights, places_.size(), step_m);
    if (!layer) return false;
    container.floor = {0, 0, *layer};
    for (int fit = 0; fit < kFits; ++fit) {
      Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
      Eigen::Vector3d sums = Eigen::Vector3d::Zero();
      int count = 0;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        const double tolerance_m = fit == 0 ? 2.5 * step_m : 0.8 * threshold(i);
        if (!level_[i] || !(std::abs(overFloor(i, container)) < tolerance_m)) continue;
        const Eigen::Vector3d place(places_[i].x, places_[i].y, 1);
        products += place * place.transpose();
        sums += height(i) * place;
        ++count;
      }
      if (count < kMinPixels) return false;
      container.floor = products.ldlt().solve(sums);
      if (!container.floor.allFinite()) return false;
    }
    return container.floor.head<2>().norm() < std::tan(kMaxTiltDeg * kDegree) && outline(container);
  }

  float height(std::size_t i) const { return map_.height_m(part_.pixels[i] / width_, part_.pixels[i] % width_); }
  float threshold(std::size_t i) const { return map_.threshold_m(part_.pixels[i] / width_, part_.pixels[i] % width_); }
  double overFloor(std::size_t i, const Container& container) const {
    return height(i) - container.floorHeight(places_[i].x, places_[i].y);
  }

 private:
  /// The hull of the larger patches of the floor.
  bool outline(Container& container) const {
    cv::Mat_<uchar> floor(part_.box.size(), uchar(0));
    cv::Mat_<int> index(part_.box.size(), -1);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!level_[i] || !(std::abs(overFloor(i, container)) < threshold(i))) continue;
      const int v = part_.pixels[i] / width_ - part_.box.y, u = part_.pixels[i] % width_ - part_.box.x;
      floor(v, u) = 255;
      index(v, u) = static_cast<int>(i);
    }
    const double all = cv::countNonZero(floor);
    cv::morphologyEx(floor, floor, cv::MORPH_OPEN, cv::Mat::ones(5, 5, CV_8U));
    const MaskComponents patches = findComponents(floor, Neighbours::kEight);
    std::vector<int> sizes(patches.count, 0);
    for (const Run& run : patches.runs) sizes[run.part] += run.last - run.first;
    std::vector<cv::Point2f> ends;
    for (const Run& run : patches.runs) {
      if (sizes[run.part] < std::max<double>(kMinPixels, kMinPatchShare * all)) continue;
      for (int u = run.first; u < run.last; ++u) {
        if (index(run.row, u) >= 0) ends.push_back(places_[index(run.row, u)]);
      }
    }
    if (ends.size() < kMinPixels) return false;
    cv::convexHull(ends, container.outline);
    // TableClusters in its corners hide the floor there.
    const cv::RotatedRect around = cv::minAreaRect(container.outline);
    if (cv::contourArea(container.outline) > kRectangular * around.size.area()) {
      cv::Point2f corners[4];
      around.points(corners);
      container.outline.assign(corners, corners + 4);
    }
    return cv::contourArea(container.outline) >= kMinFloorM2 &&
           std::max(around.size.width, around.size.height) <= kMaxFloorM;
  }

  const Enclosed& part_;
  const HeightMap& map_;
  int width_;
  std::vector<cv::Point2f> places_;
  std::vector<char> level_;
};

/// Whether things are on the floor: an empty container is one itself.
bool hasContents(const FloorFinder& finder, const Container& container) {
  const ConvexArea area(container.outline);
  int inside = 0, over = 0;
  for (std::size_t i = 0; i < finder.places().size(); ++i) {
    if (!area.contains(finder.places()[i], -kFootM)) continue;
    ++inside;
    over += finder.overFloor(i, container) > finder.threshold(i);
  }
  return over >= kMinPixels && over >= kMinContents * inside;
}

}  // namespace

std::vector<Container> findContainers(const Frame& frame, const Normals& normals, const Table& table,
                                      const HeightMap& map, const cv::Mat_<uchar>& mask) {
  std::vector<Container> containers;
  for (Enclosed& part : enclosedParts(frame, mask)) {
    const FloorFinder finder(frame, normals, table, map, part);
    Container container;
    if (!finder.find(container)) continue;
    std::vector<float> over_floor, thresholds;
    for (std::size_t i = 0; i < part.pixels.size(); ++i) {
      over_floor.push_back(static_cast<float>(finder.overFloor(i, container)));
      thresholds.push_back(finder.threshold(i));
    }
    const auto wall = wallHeight(container.outline, finder.places(), over_floor, shareBelow(0.5, thresholds));
    if (!wall) continue;
    container.wall_height_m = *wall;
    if (!hasContents(finder, container)) continue;
    container.pixels = std::move(part.pixels);
    containers.push_back(std::move(container));
  }
  return containers;
}

ContainerMasks takeContainers(const Frame& frame, const Normals& normals, const Table& table,
                              const std::vector<Container>& containers, HeightMap& map, cv::Mat_<uchar>& mask) {
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  const Eigen::Vector3f up = table.normal.cast<float>();
  const int width = mask.cols;
  ContainerMasks taken{cv::Mat_<uchar>::zeros(mask.size()), cv::Mat_<uchar>::zeros(mask.size())};
  if (containers.empty()) return taken;
  HeightMap over_floors = map;
  over_floors.height_m = cv::Mat_<float>(mask.size(), std::nanf(""));
  for (const Container& container : containers) {
    const ConvexArea floor(container.outline);
    const float near_wall_m = std::max(kNearWallM, kNearWall * static_cast<float>(container.wall_height_m));
    for (const int pixel : container.pixels) {
      const int v = pixel / width, u = pixel % width;
      const Eigen::Vector3f place = T_table_camera * frame.points[pixel];
      const double height_m = place.z() - container.floorHeight(place.x(), place.y());
      const bool steep = normals.radius_px[pixel] > 0 && normals.normal[pixel].dot(up) < kSteepCosine;
      const bool on_floor = std::abs(height_m) <= map.threshold_m(v, u);
      const bool like_wall = !on_floor && (steep || height_m > 0.5 * container.wall_height_m);
      const bool over = floor.contains({place.x(), place.y()}, like_wall ? -near_wall_m : -kFootM);
      taken.all(v, u) = 255;
      if (over && on_floor) taken.floor(v, u) = 255;
      mask(v, u) = 0;
      map.inside(v, u) = 255;
      if (over || height_m > highestWall(container.wall_height_m) + map.threshold_m(v, u)) {
        over_floors.height_m(v, u) = static_cast<float>(height_m);
      }
    }
  }
  const cv::Mat_<uchar> contents = aboveTable(over_floors) & taken.all;
  mask |= contents;
  taken.all.setTo(0, contents);
  taken.floor.setTo(0, contents);
  return taken;
}

}  // namespace objectness

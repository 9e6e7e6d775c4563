// SPDX-License-Identifier: BSD-3-Clause
#include "standing_things.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr int kMinFloorPixels = 20;
constexpr double kFloorThicknessM = 0.0012;  // a bowl's floor lies higher than the table around it, a ring's hole does not
constexpr double kAroundM = 0.05;            // where the table around a thing is measured
constexpr int kMinAroundPixels = 50;

constexpr float kSameRimM = 0.01f;

/// Connected pixels that are no thing.
struct Region {
  int pixels = 0;
  bool open = false;        // not enclosed: reaches the image border or touches more than two things
  int things[2] = {0, 0};   // that it touches; 0 = none
  cv::Rect box;

  void touches(int thing) {
    if (thing == things[0] || thing == things[1]) return;
    if (things[0] == 0) {
      things[0] = thing;
    } else if (things[1] == 0) {
      things[1] = thing;
    } else {
      open = true;
    }
  }
};

cv::Point cellOf(const Eigen::Vector2f& foot, const TableExtent& extent) {
  const Eigen::Vector2d cell = (foot.cast<double>() - extent.origin) / extent.cell_m;
  return {static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y()))};
}

cv::Mat_<uchar> convexHullRaster(const std::vector<cv::Point>& cells, const cv::Size& size) {
  std::vector<cv::Point> hull;
  cv::convexHull(cells, hull);
  cv::Mat_<uchar> raster(size, uchar(0));
  cv::fillConvexPoly(raster, hull, cv::Scalar(255));
  return raster;
}

double median(std::vector<float>& values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median height of the table next to a region's thing; NaN when it is not seen.
double tableAround(const cv::Rect& box, const HeightMap& map, const Things& things) {
  std::vector<float> heights;
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      const float h = map.height_m(v, u);
      if (things.label(v, u) == 0 && std::abs(h) <= map.threshold_m(v, u)) heights.push_back(h);
    }
  }
  return heights.size() < static_cast<std::size_t>(kMinAroundPixels) ? std::nan("") : median(heights);
}

}  // namespace

void addHollowFloors(const Frame& frame, const Table& table, const HeightMap& map, const Things& things,
                     cv::Mat_<uchar>& mask) {
  const int width = frame.width(), height = frame.height();
  const Eigen::Matrix<float, 2, 3> axes = table.T_table_camera.linear().topRows<2>().cast<float>();

  // Regions and what they touch.
  const cv::Mat_<uchar> free = things.label == 0;
  cv::Mat labels_mat, stats, centroids;
  const int count = cv::connectedComponentsWithStats(free, labels_mat, stats, centroids, 4);
  const cv::Mat_<int> labels = labels_mat;
  std::vector<Region> regions(count);
  for (int k = 1; k < count; ++k) {
    Region& region = regions[k];
    region.pixels = stats.at<int>(k, cv::CC_STAT_AREA);
    region.box = cv::Rect(stats.at<int>(k, cv::CC_STAT_LEFT), stats.at<int>(k, cv::CC_STAT_TOP),
                          stats.at<int>(k, cv::CC_STAT_WIDTH), stats.at<int>(k, cv::CC_STAT_HEIGHT));
    const bool at_border = region.box.x == 0 || region.box.y == 0 || region.box.br().x == width || region.box.br().y == height;
    region.open = at_border || region.pixels < kMinFloorPixels;
  }
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const int thing = things.label(v, u);
      if (thing == 0) continue;
      for (const cv::Point q : {cv::Point(u - 1, v), cv::Point(u + 1, v), cv::Point(u, v - 1), cv::Point(u, v + 1)}) {
        if (q.x < 0 || q.y < 0 || q.x >= width || q.y >= height || things.label(q) == thing) continue;
        if (labels(q) > 0) regions[labels(q)].touches(thing);
      }
    }
  }
  // A bowl often falls into the outside of its front and the inside of its back: two things with one rim.
  std::vector<float> rim(things.count + 1, 0);
  for (int i = 0; i < frame.size(); ++i) {
    float& height_of_rim = rim[things.label.ptr<int>()[i]];
    if (things.label.ptr<int>()[i] > 0) height_of_rim = std::max(height_of_rim, map.height_m.ptr<float>()[i]);
  }
  std::vector<bool> hollow(things.count + 1, false);
  for (int k = 1; k < count; ++k) {
    Region& region = regions[k];
    if (region.things[1] > 0 && std::abs(rim[region.things[0]] - rim[region.things[1]]) > kSameRimM) region.open = true;
    if (region.things[0] == 0) region.open = true;
    if (!region.open) hollow[region.things[0]] = hollow[region.things[1]] = true;
  }
  hollow[0] = false;
  std::vector<std::vector<cv::Point>> footprints(things.count + 1);  // their convex hulls, in cells of the table's extent
  for (int i = 0; i < frame.size(); ++i) {
    const int thing = things.label.ptr<int>()[i];
    if (hollow[thing]) footprints[thing].push_back(cellOf(axes * frame.points[i], table.extent));
  }
  for (std::vector<cv::Point>& footprint : footprints) {
    const std::vector<cv::Point> cells = std::move(footprint);
    footprint.clear();
    if (!cells.empty()) cv::convexHull(cells, footprint);
  }

  for (int k = 1; k < count; ++k) {
    const Region& region = regions[k];
    if (region.open) continue;
    std::vector<cv::Point> footprint = footprints[region.things[0]];
    const std::vector<cv::Point>& second = footprints[region.things[1]];
    footprint.insert(footprint.end(), second.begin(), second.end());
    const cv::Mat_<uchar> hull = convexHullRaster(footprint, table.extent.cells.size());
    std::vector<cv::Point> floor;
    std::vector<float> heights;
    double depth = 0;
    for (int v = region.box.y; v < region.box.br().y; ++v) {
      for (int u = region.box.x; u < region.box.br().x; ++u) {
        const float h = map.height_m(v, u);
        if (labels(v, u) != k || !(std::abs(h) <= 2 * map.threshold_m(v, u))) continue;
        const Eigen::Vector3f& p = frame.points[v * width + u];
        const cv::Point cell = cellOf(axes * p, table.extent);
        if (!cv::Rect(0, 0, hull.cols, hull.rows).contains(cell) || hull(cell) == 0) continue;
        floor.emplace_back(u, v);
        heights.push_back(h);
        depth += p.z();
      }
    }
    if (floor.size() < static_cast<std::size_t>(kMinFloorPixels)) continue;
    const int around = static_cast<int>(std::ceil(kAroundM * frame.camera.focal() * floor.size() / depth));
    cv::Rect box = region.box;
    box -= cv::Point(2 * around, 2 * around);
    box += cv::Size(4 * around, 4 * around);
    const double reference = tableAround(box & cv::Rect(0, 0, width, height), map, things);
    if (median(heights) < reference + kFloorThicknessM) continue;
    for (const cv::Point& pixel : floor) mask(pixel) = 255;
  }
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "scene/hollow_floors.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "common/upper_median.hpp"
#include "scene/connected_components_2d.hpp"

namespace objectness {
namespace {

constexpr int kMinFloorPixels = 20;
constexpr double kFloorThicknessM =
    0.0012;                        // a bowl's floor lies higher than the table around it, a ring's hole does not
constexpr double kAroundM = 0.10;  // where the table around a thing is measured
constexpr int kMinAroundPixels = 50;

constexpr float kSameRimM = 0.01f;
constexpr float kLowShare = 0.5f;  // of the rim: lower things lie within

/// Connected pixels that are no thing.
struct Region {
  bool open = false;       // not enclosed: reaches the image border or touches more than two things
  int things[2] = {0, 0};  // that it touches; 0 = none
  cv::Rect box;
  std::set<int> touched;

  /// The things that enclose it: not what lies low on its floor.
  void chooseThings(const std::vector<float>& rim_m) {
    float highest = 0;
    for (const int thing : touched) highest = std::max(highest, rim_m[thing]);
    int found = 0;
    for (const int thing : touched) {
      if (rim_m[thing] < kLowShare * highest) continue;
      if (found == 2) open = true;
      if (found < 2) things[found++] = thing;
    }
    // A bowl often falls into the outside of its front and the inside of its back: two things with one rim.
    if (found == 0 || (found == 2 && std::abs(rim_m[things[0]] - rim_m[things[1]]) > kSameRimM)) open = true;
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

/// Height of the highest point of each thing.
std::vector<float> rims(const TableClusters& clusters, const HeightMap& map) {
  std::vector<float> rim_m(clusters.count + 1, 0);
  for (int v = 0; v < clusters.label.rows; ++v) {
    const int* thing = clusters.label[v];
    const float* height = map.height_m[v];
    for (int u = 0; u < clusters.label.cols; ++u) {
      if (thing[u] > 0) rim_m[thing[u]] = std::max(rim_m[thing[u]], height[u]);
    }
  }
  return rim_m;
}

/// Connected pixels (4 neighbours) that are no thing, as runs with what they touch.
struct Regions {
  MaskComponents parts;
  std::vector<Region> regions;  ///< by part

  bool allOpen() const {
    return std::all_of(regions.begin(), regions.end(), [](const Region& region) { return region.open; });
  }
};

/// Regions that are not open have the things they touch.
Regions findRegions(const TableClusters& clusters, const HeightMap& map) {
  const int width = clusters.label.cols, height = clusters.label.rows;
  Regions found;
  found.parts = findComponents(clusters.label == 0, Neighbours::kFour);
  std::vector<int> pixels(found.parts.count, 0);
  found.regions.resize(found.parts.count);
  for (const Run& run : found.parts.runs) {
    cv::Rect& box = found.regions[run.part].box;
    box |= cv::Rect(run.first, run.row, run.last - run.first, 1);
    pixels[run.part] += run.last - run.first;
  }
  for (int k = 0; k < found.parts.count; ++k) {
    const cv::Rect& box = found.regions[k].box;
    const bool at_border = box.x == 0 || box.y == 0 || box.br().x == width || box.br().y == height;
    found.regions[k].open = at_border || pixels[k] < kMinFloorPixels;
  }
  if (found.allOpen()) return found;
  for (const Run& run : found.parts.runs) {
    Region& region = found.regions[run.part];
    if (region.open) continue;
    const auto touch = [&](int v, int u) {
      if (clusters.label(v, u) > 0) region.touched.insert(clusters.label(v, u));
    };
    touch(run.row, run.first - 1);
    touch(run.row, run.last);
    for (int u = run.first; u < run.last; ++u) touch(run.row - 1, u), touch(run.row + 1, u);
  }
  const std::vector<float> rim_m = rims(clusters, map);
  for (Region& region : found.regions) {
    if (!region.open) region.chooseThings(rim_m);
  }
  return found;
}

/// Convex hulls of the things around closed regions, seen from above, in cells of the table's extent.
std::vector<std::vector<cv::Point>> footprints(const Frame& frame, const Table& table, const TableClusters& clusters,
                                               const std::vector<Region>& regions) {
  std::vector<char> wanted(clusters.count + 1, false);
  for (const Region& region : regions) {
    if (!region.open) wanted[region.things[0]] = wanted[region.things[1]] = true;
  }
  wanted[0] = false;
  const Eigen::Matrix<float, 2, 3> axes = table.T_table_camera.linear().topRows<2>().cast<float>();
  std::vector<std::vector<cv::Point>> cells(clusters.count + 1), hulls(clusters.count + 1);
  for (int v = 0; v < clusters.label.rows; ++v) {
    const int* label = clusters.label[v];
    const Eigen::Vector3f* point = frame.points.data() + std::size_t(v) * clusters.label.cols;
    for (int u = 0; u < clusters.label.cols; ++u) {
      if (!wanted[label[u]]) continue;
      std::vector<cv::Point>& of_thing = cells[label[u]];
      const cv::Point cell = cellOf(axes * point[u], table.extent);
      if (of_thing.empty() || of_thing.back() != cell) of_thing.push_back(cell);  // many pixels in a row see one cell
    }
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!cells[k].empty()) cv::convexHull(cells[k], hulls[k]);
  }
  return hulls;
}

/// Median height of the table next to a region; NaN when it is not seen.
double tableAround(const cv::Rect& region, int reach_px, const HeightMap& map, const TableClusters& clusters) {
  const cv::Rect image(0, 0, map.height_m.cols, map.height_m.rows);
  const cv::Rect box =
      cv::Rect(region.x - reach_px, region.y - reach_px, region.width + 2 * reach_px, region.height + 2 * reach_px) &
      image;
  std::vector<float> heights;
  for (int v = box.y; v < box.br().y; ++v) {
    for (int u = box.x; u < box.br().x; ++u) {
      const float h = map.height_m(v, u);
      if (clusters.label(v, u) > 0 || region.contains({u, v}) || !(std::abs(h) <= map.threshold_m(v, u))) continue;
      heights.push_back(h);
    }
  }
  return heights.size() < static_cast<std::size_t>(kMinAroundPixels) ? std::nan("") : upperMedian(heights);
}

}  // namespace

void addHollowFloors(const Frame& frame, const Table& table, const HeightMap& map, const TableClusters& clusters,
                     cv::Mat_<uchar>& mask) {
  const Regions found = findRegions(clusters, map);
  const std::vector<Region>& regions = found.regions;
  if (found.allOpen()) return;
  const std::vector<std::vector<cv::Point>> hulls = footprints(frame, table, clusters, regions);
  const Eigen::Matrix<float, 2, 3> axes = table.T_table_camera.linear().topRows<2>().cast<float>();

  std::vector<std::vector<Run>> runs(regions.size());
  for (const Run& run : found.parts.runs) {
    if (!regions[run.part].open) runs[run.part].push_back(run);
  }
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const Region& region = regions[k];
    if (region.open) continue;
    std::vector<cv::Point> level;  // with the table, about
    for (const Run& run : runs[k]) {
      for (int u = run.first; u < run.last; ++u) {
        const bool is_level = std::abs(map.height_m(run.row, u)) <= 2 * map.threshold_m(run.row, u);
        if (is_level) level.emplace_back(u, run.row);
      }
    }
    if (level.size() < static_cast<std::size_t>(kMinFloorPixels)) continue;

    std::vector<cv::Point> footprint = hulls[region.things[0]];
    const std::vector<cv::Point>& second = hulls[region.things[1]];
    footprint.insert(footprint.end(), second.begin(), second.end());
    const cv::Mat_<uchar> inside = convexHullRaster(footprint, table.extent.cells.size());
    std::vector<cv::Point> floor;
    std::vector<float> heights;
    double depth = 0;
    for (const cv::Point& pixel : level) {
      const Eigen::Vector3f& p = frame.points[static_cast<std::size_t>(pixel.y) * frame.width() + pixel.x];
      const cv::Point cell = cellOf(axes * p, table.extent);
      if (!cv::Rect(0, 0, inside.cols, inside.rows).contains(cell) || inside(cell) == 0) continue;
      floor.push_back(pixel);
      heights.push_back(map.height_m(pixel));
      depth += p.z();
    }
    if (floor.size() < static_cast<std::size_t>(kMinFloorPixels)) continue;
    const int reach_px = static_cast<int>(std::ceil(kAroundM * frame.camera.focal() * floor.size() / depth));
    if (upperMedian(heights) < tableAround(region.box, reach_px, map, clusters) + kFloorThicknessM) continue;
    for (const cv::Point& pixel : floor) mask(pixel) = 255;
  }
}

}  // namespace objectness

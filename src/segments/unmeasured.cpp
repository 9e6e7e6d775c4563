// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/segments/unmeasured.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "segments/compact_holes.hpp"
#include "segments/hole_box.hpp"
#include "segments/hole_explanations.hpp"

namespace objectness {
namespace {

constexpr double kMinSolidity = 0.85;  // of a hole in its convex hull
constexpr double kMinOnTable = 0.9;    // of its outline
constexpr double kOutlineErrorPx = 1.0;

using Contour = std::vector<cv::Point>;

/// The outer border of a hole: its own outermost pixels.
Contour borderOf(const CompactHole& hole) {
  std::vector<Contour> contours;
  cv::findContours(hole.mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, hole.area.tl());
  return contours.empty() ? Contour() : contours.front();
}

bool isCompact(const Contour& border) {
  Contour hull;
  cv::convexHull(border, hull);
  return cv::contourArea(border) >= kMinSolidity * cv::contourArea(hull);
}

/// Where pixels see the table.
class TableView {
 public:
  TableView(const PinholeCamera& camera, const Table& table) : camera_(camera), table_(table) {}

  /// Metres along the optical axis; negative: the ray never meets the table.
  double depth(const cv::Point& pixel) const { return -table_.d / table_.normal.dot(camera_.ray(pixel.x, pixel.y)); }
  Eigen::Vector3d place(const cv::Point& pixel) const { return depth(pixel) * camera_.ray(pixel.x, pixel.y); }

  /// Places in the table frame; empty where a pixel looks past the table's plane, or many past its extent.
  std::vector<Eigen::Vector2d> places(const Contour& pixels) const {
    std::vector<Eigen::Vector2d> places;
    std::size_t on_table = 0;
    for (const cv::Point& pixel : pixels) {
      if (!(depth(pixel) > 0)) return {};
      places.push_back((table_.T_table_camera * place(pixel)).head<2>());
      on_table += table_.extent.contains(places.back().x(), places.back().y());
    }
    if (static_cast<double>(on_table) < kMinOnTable * static_cast<double>(pixels.size())) return {};
    return places;
  }
  /// Of the table behind one pixel. Of a plane at distance d the ray (x, y, 1) sees z^3 / d dx dy.
  double area(const cv::Point& pixel) const {
    const double z = depth(pixel);
    return z * z * z / (table_.d * camera_.fx * camera_.fy);
  }

 private:
  const PinholeCamera& camera_;
  const Table& table_;
};

cv::Mat_<uchar> withoutDepth(const cv::Mat_<float>& height_m) {
  cv::Mat_<uchar> none(height_m.size());
  for (int v = 0; v < none.rows; ++v) {
    const float* height = height_m[v];
    uchar* row = none[v];
    for (int u = 0; u < none.cols; ++u) row[u] = std::isnan(height[u]) ? 255 : 0;
  }
  return none;
}

double areaOf(const CompactHole& hole, const TableView& view) {
  double area = 0;
  for (int y = 0; y < hole.mask.rows; ++y) {
    for (int x = 0; x < hole.mask.cols; ++x) {
      if (hole.mask(y, x)) area += view.area({hole.area.x + x, hole.area.y + y});
    }
  }
  return area;
}

std::vector<Eigen::Vector3d> outlineOf(const Contour& border, const TableView& view, const Table& table) {
  Contour corners;
  cv::approxPolyDP(border, corners, kOutlineErrorPx, true);
  std::vector<Eigen::Vector3d> outline;
  for (const cv::Point& corner : corners) outline.push_back(view.place(corner));
  double turns = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    turns += table.normal.dot(outline[k].cross(outline[(k + 1) % outline.size()]));
  if (turns < 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

}  // namespace

std::vector<Unmeasured> findUnmeasured(const Frame& frame, const Table& table, const ObjectPoints& above,
                                       const cv::Mat_<ushort>& labels, const std::vector<Segment>& segments,
                                       const UnmeasuredConfig& config) {
  const cv::Mat_<uchar> no_depth = withoutDepth(above.height_m);
  const KnownThings known(frame.camera, segments);
  const TableView view(frame.camera, table);
  std::vector<Unmeasured> found;
  for (const CompactHole& hole : compactHoles(frame.camera, table, no_depth, above.on_table, config)) {
    const double table_share = tableAround(hole, labels, above.height_m);
    if (!(table_share >= config.min_table_share) || isShadow(hole, frame) || known.hold(hole)) continue;
    const Contour border = borderOf(hole);
    if (!isCompact(border)) continue;
    const std::vector<Eigen::Vector2d> places = view.places(border);
    if (places.empty()) continue;
    Unmeasured thing;
    thing.outline = outlineOf(border, view, table);
    thing.pixels = hole.pixels;
    thing.area_m2 = areaOf(hole, view);
    thing.table_share = table_share;
    thing.noise_ratio = hole.radius_px / hole.noise_radius_px;
    thing.box = boxOfHole(table, places);
    found.push_back(std::move(thing));
  }
  return found;
}

}  // namespace objectness

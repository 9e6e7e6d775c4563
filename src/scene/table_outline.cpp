// SPDX-License-Identifier: BSD-3-Clause
#include "scene/table_outline.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "common/upper_median.hpp"
#include "scene/outline_polygon.hpp"
#include "scene/plane_grid.hpp"
#include "scene/projector_shadow.hpp"
#include "scene/surface_samples.hpp"

namespace objectness {
namespace {

constexpr double kInwardsM = 0.05, kOutwardsM = 0.07;  // of the core's border, for the edge to be looked for
constexpr double kStepM = 0.002;
constexpr int kMinSurfaceSteps = 3;                    // less in a row is a speck
constexpr int kTangentCells = 4;                       // each way along the border
constexpr double kMaxHoleM = 0.02;                     // without depth, between the surface and what is behind it
constexpr float kMinToleranceM = 0.006f, kSigmas = 3;  // as of SurfaceSamples
constexpr std::size_t kNeighbours = 4;
constexpr double kMaxOutlierM = 0.012;  // from the neighbours' median

/// What a pixel says of the place of the plane that it sees.
enum class Sight { kSurface, kBehind, kOver, kNothing, kOutOfPicture };

/// The picture, asked by places of the table's plane.
class PlaneView {
 public:
  PlaneView(const Frame& frame, const Table& table)
      : frame_(frame), noise_(table.noise), plane_(table), T_table_camera_(table.T_table_camera) {
    const Eigen::Isometry3d T_camera_table = T_table_camera_.inverse();
    axes_ = T_camera_table.linear().leftCols<2>();
    origin_ = T_camera_table.translation();
  }

  /// Index of the pixel, -1 out of the picture.
  int pixel(const Eigen::Vector2d& place) const {
    const Eigen::Vector3d p = axes_ * place + origin_;
    if (!(p.z() > 0)) return -1;
    const Eigen::Vector2d at = frame_.camera.project(p);
    if (!(at.x() > -0.5 && at.y() > -0.5 && at.x() < frame_.width() - 0.5 && at.y() < frame_.height() - 0.5)) return -1;
    return static_cast<int>(std::lround(at.y())) * frame_.width() + static_cast<int>(std::lround(at.x()));
  }
  Sight sight(int pixel) const {
    if (pixel < 0) return Sight::kOutOfPicture;
    const Eigen::Vector3f& p = frame_.points[pixel];
    if (!(p.z() > 0)) return Sight::kNothing;
    const float height = plane_.height(p);
    const float tolerance = std::max(kMinToleranceM, kSigmas * static_cast<float>(noise_.sigma(p.z())));
    return height > tolerance ? Sight::kOver : height < -tolerance ? Sight::kBehind : Sight::kSurface;
  }
  /// Where the pixel's ray crosses the plane.
  Eigen::Vector2d crossing(int pixel) const {
    const Eigen::Vector3d ray = frame_.camera.ray(pixel % frame_.width(), pixel / frame_.width());
    const double along = plane_.normal.cast<double>().dot(ray);
    return (T_table_camera_ * (-plane_.d / along * ray)).head<2>();
  }
  /// The place that the pixel's point is over.
  Eigen::Vector2d foot(int pixel) const { return (T_table_camera_ * frame_.points[pixel].cast<double>()).head<2>(); }

  /// Whether what a projector beside the camera (along the rows) does not reach may explain that there is no depth
  /// between two pixels, the first on the table and the second behind it.
  bool mayBeShadow(int from, int to) const {
    const int du = std::abs(to % frame_.width() - from % frame_.width());
    const int dv = std::abs(to / frame_.width() - from / frame_.width());
    const double widest = widestShadowPx(frame_.camera.fx, frame_.points[from].z(), frame_.points[to].z());
    return dv <= du && du <= widest;
  }

 private:
  const Frame& frame_;
  const DepthNoise noise_;
  const FastPlane plane_;
  const Eigen::Isometry3d T_table_camera_;
  Eigen::Matrix<double, 3, 2> axes_;
  Eigen::Vector3d origin_;
};

/// Where the surface ends along a line outwards, metres from its start.
struct Edge {
  double at;
  bool measured;  ///< what is behind the surface is seen next to it; otherwise there is only no depth
};

/// The end of the surface near to `start` along `outwards`; of several the nearest. Nothing where the surface does not
/// end, or does not do so in view.
std::optional<Edge> edgeFrom(const Eigen::Vector2d& start, const Eigen::Vector2d& outwards, const PlaneView& view) {
  std::optional<Edge> nearest;
  int last = -1, next = -1, surface = 0;  // the last pixel on the surface, the one after it, and its steps in a row
  double last_at = 0;
  const auto end = [&](bool measured) {
    if (surface < kMinSurfaceSteps || next < 0) return;
    // The surface ends between two pixels; of a table's side some are within the tolerance, straight under the edge.
    const double step = (view.crossing(next) - view.crossing(last)).dot(outwards);
    const Edge edge{(view.foot(last) - start).dot(outwards) + 0.5 * std::clamp(step, 0.0, kMaxHoleM), measured};
    const bool better = !nearest || (measured && !nearest->measured) ||
                        (measured == nearest->measured && std::abs(edge.at) < std::abs(nearest->at));
    if (better) nearest = edge;
  };
  for (double at = -kInwardsM; at <= kOutwardsM; at += kStepM) {
    const int pixel = view.pixel(start + at * outwards);
    const Sight sight = view.sight(pixel);
    if (sight == Sight::kSurface) {
      last = pixel;
      next = -1;
      last_at = at;
      ++surface;
      continue;
    }
    if (last >= 0 && next < 0) next = pixel;
    if (sight == Sight::kNothing) continue;
    if (sight == Sight::kBehind && last >= 0) end(at - last_at <= kMaxHoleM || view.mayBeShadow(last, pixel));
    last = next = -1;
    surface = 0;
  }
  if (last >= 0 && next >= 0) end(false);
  return nearest;
}

/// The outer border of the extent's core, a place a cell, counter-clockwise.
std::vector<Eigen::Vector2d> borderOf(const TableExtent& extent) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(extent.cells == TableExtent::kCore, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  const auto longest = std::max_element(contours.begin(), contours.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (longest == contours.end()) return {};
  // x to the right and y downwards in the raster are x and y of the table: OpenCV's clockwise is our counter-clockwise.
  if (cv::contourArea(*longest, true) < 0) std::reverse(longest->begin(), longest->end());
  std::vector<Eigen::Vector2d> border;
  for (const cv::Point& p : *longest) {
    border.push_back(extent.origin + extent.cell_m * Eigen::Vector2d(p.x + 0.5, p.y + 0.5));
  }
  return border;
}

/// Takes back the edges that are not where their neighbours on the border have theirs.
void removeOutliers(std::vector<std::optional<Edge>>& edges) {
  const std::vector<std::optional<Edge>> all = edges;
  std::vector<double> near;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i]) continue;
    near.clear();
    for (std::size_t k = 0; k <= 2 * kNeighbours; ++k) {
      const auto& edge = all[(i + all.size() + k - kNeighbours) % all.size()];
      if (edge) near.push_back(edge->at);
    }
    if (near.size() <= kNeighbours / 2 || std::abs(all[i]->at - upperMedian(near)) > kMaxOutlierM) edges[i].reset();
  }
}

}  // namespace

void traceOutline(const Frame& frame, Table& table) {
  table.hull.clear();
  table.hull_measured.clear();
  const std::vector<Eigen::Vector2d> border = borderOf(table.extent);
  const std::size_t count = border.size();
  if (count <= 2 * kNeighbours) return;
  const auto at = [&](std::size_t i) { return border[i % count]; };
  const PlaneView view(frame, table);
  std::vector<OutlinePoint> points(count);
  std::vector<Eigen::Vector2d> outwards(count, Eigen::Vector2d::Zero());
  std::vector<std::optional<Edge>> edges(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d along = at(i + kTangentCells) - at(i + count - kTangentCells);
    points[i].place = (at(i + count - 1) + at(i) + at(i + 1)) / 3;  // without the steps of the raster
    if (!(along.norm() > 0)) continue;
    outwards[i] = Eigen::Vector2d(along.y(), -along.x()).normalized();
    edges[i] = edgeFrom(points[i].place, outwards[i], view);
  }
  removeOutliers(edges);
  for (std::size_t i = 0; i < count; ++i) {
    points[i].measured = edges[i] && edges[i]->measured;
    points[i].place += (edges[i] ? edges[i]->at : 0.5 * table.extent.cell_m) * outwards[i];
  }
  OutlinePolygon polygon = polygonThrough(points);
  table.hull = std::move(polygon.corners);
  table.hull_measured = std::move(polygon.measured);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "scene/plane_grid.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "common/parallel.hpp"
#include "common/upper_median.hpp"
#include "scene/foot_height.hpp"

namespace objectness {
namespace {

constexpr double kMaxReachM = 4.0;           // of a table from its middle; keeps the grid of a hall's floor small
constexpr double kBridgedGapM = 0.025;       // missing depth within the surface
constexpr double kSpeckM = 0.015;            // points that only happen to be at table height
constexpr double kMinPartM2 = 0.0025;        // of the surface seen between things; smaller ones are not part of it
constexpr double kBridgedThingM = 0.32;      // between parts of the surface, under a thing or its shadow
constexpr double kReachM = 0.16;             // how far the table goes on under objects past its last visible cell
constexpr double kRimM = 0.05;               // things stand at the very edge, and table edges are rounded
constexpr float kMinNormalCosine = 0.9063f;  // 25 deg
constexpr float kBehindM = 0.015f;           // beyond the tolerance: further behind the plane than any dent of a table
constexpr float kCoverCeilingM = 0.45f;      // higher things rather stand behind the table
constexpr double kBeyondM = 0.32;            // from the extent to things, where there is no depth between
constexpr double kClearOfThroughM = 0.03;    // of the way to them, and of their feet
constexpr int kMinFootCells = 3;
constexpr int kBands = 4;  // of the samples, for threads to look at

/// Structuring element that reaches this far to each side.
cv::Mat square(double reach_m, double cell_m) {
  const int reach = std::max(1, static_cast<int>(std::lround(reach_m / cell_m)));
  return cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
}

cv::Mat_<uchar> withoutSmallParts(const cv::Mat_<uchar>& cells, double min_cells) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(cells, labels, stats, centroids, 8);
  std::vector<uchar> keep(count, 0);
  for (int i = 1; i < count; ++i) keep[i] = stats.at<int>(i, cv::CC_STAT_AREA) >= min_cells ? 255 : 0;
  cv::Mat_<uchar> result(cells.size());
  std::transform(labels.begin<int>(), labels.end<int>(), result.begin(), [&](int label) { return keep[label]; });
  return result;
}

/// The connected part of `cells` that holds most of `counted`.
cv::Mat_<uchar> mainPart(const cv::Mat_<uchar>& cells, const cv::Mat_<uchar>& counted) {
  cv::Mat labels;
  std::vector<int> counts(cv::connectedComponents(cells, labels, 4, CV_32S), 0);
  for (std::size_t i = 0; i < cells.total(); ++i) {
    if (cells.data[i] && counted.data[i]) ++counts[labels.ptr<int>()[i]];
  }
  const auto best = std::max_element(counts.begin(), counts.end());
  if (*best == 0) return cv::Mat_<uchar>(cells.size(), uchar(0));
  return cv::Mat_<uchar>(labels == static_cast<int>(best - counts.begin()));
}

cv::Mat_<uchar> fillHoles(const cv::Mat_<uchar>& cells) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(cells.clone(), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat_<uchar> filled(cells.size(), uchar(0));
  cv::drawContours(filled, contours, -1, cv::Scalar(255), cv::FILLED);
  return filled;
}

/// Lays the grid over the points on the plane: around their middle, as far as they go or a table can reach.
void lay(const std::vector<std::vector<Eigen::Vector2f>>& on_plane, int threads, PlaneGrid& grid) {
  const auto middleOf = [&](int axis) {
    std::vector<float> values;
    values.reserve(grid.samples_on_plane);
    for (const auto& points : on_plane) {
      for (const auto& p : points) values.push_back(p[axis]);
    }
    return upperMedian(values);
  };
  Eigen::Vector2d middle;
  parallelFor(2, threads, [&](int axis) { middle[axis] = middleOf(axis); });
  Eigen::Vector2d low = middle, high = middle;
  for (const auto& points : on_plane) {
    for (const auto& p : points) {
      low = low.cwiseMin(p.cast<double>());
      high = high.cwiseMax(p.cast<double>());
    }
  }
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(kMaxReachM);
  low = low.cwiseMax(middle - reach) - Eigen::Vector2d::Constant(kReachM);
  high = high.cwiseMin(middle + reach) + Eigen::Vector2d::Constant(kReachM);
  grid.origin = low;
  grid.columns = static_cast<int>(std::ceil((high.x() - low.x()) / grid.cell_m));
  grid.rows = static_cast<int>(std::ceil((high.y() - low.y()) / grid.cell_m));
}

/// What some of the samples say of the cells.
struct Marks {
  cv::Mat_<uchar> on_plane, seen_through, covered, feet;
};

}  // namespace

Eigen::Isometry3d tableFrame(const Plane& plane) {
  const Eigen::Vector3d z = plane.normal;
  // A plane seen from the side has the camera's x axis along its normal: then the y axis is the one to lay down.
  const Eigen::Vector3d along = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d x = (along - along.dot(z) * z).normalized();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear().row(0) = x;
  T.linear().row(1) = z.cross(x);
  T.linear().row(2) = z;
  T.translation() = Eigen::Vector3d(0, 0, plane.d);
  return T;
}

PlaneGrid makePlaneGrid(const SurfaceSamples& samples, const Plane& plane, double cell_m, int threads) {
  PlaneGrid grid;
  grid.T_table_camera = tableFrame(plane);
  grid.cell_m = cell_m;
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = grid.T_table_camera.linear().topRows<2>().cast<float>();
  const int bands = threads == 1 ? 1 : kBands;
  const auto forSamplesOf = [&](int band, auto&& visit) {
    const std::size_t size = samples.samples.size();
    for (std::size_t i = size * band / bands; i < size * (band + 1) / bands; ++i) {
      if (samples.samples[i].valid()) visit(samples.samples[i]);
    }
  };

  std::vector<std::vector<Eigen::Vector2f>> on_plane(bands);
  parallelFor(bands, threads, [&](int band) {
    on_plane[band].reserve(samples.samples.size() / bands + 1);
    forSamplesOf(band, [&](const auto& sample) {
      if (std::abs(fast.height(sample.point)) > sample.tolerance()) return;
      if (sample.hasNormal() && sample.normal.dot(fast.normal) < kMinNormalCosine) return;
      on_plane[band].push_back(axes * sample.point);
    });
  });
  for (const auto& points : on_plane) grid.samples_on_plane += static_cast<int>(points.size());
  if (grid.samples_on_plane == 0) return grid;
  lay(on_plane, threads, grid);

  std::vector<Marks> marks(bands);
  parallelFor(bands, threads, [&](int band) {
    Marks& mark = marks[band];
    for (cv::Mat_<uchar>* cells : {&mark.on_plane, &mark.seen_through, &mark.covered, &mark.feet}) {
      *cells = cv::Mat_<uchar>(grid.rows, grid.columns, uchar(0));
    }
    cv::Point cell;
    for (const auto& p : on_plane[band]) {
      if (grid.cell(p.x(), p.y(), cell)) mark.on_plane(cell) = 255;
    }
    forSamplesOf(band, [&](const auto& sample) {
      const float height = fast.height(sample.point);
      const bool behind = height < -(sample.tolerance() + kBehindM);
      const bool over = height > sample.tolerance() && height < kCoverCeilingM;
      if (!behind && !over) return;  // most of a view
      const Eigen::Vector2f foot = axes * sample.point;
      const float scale = fast.d / (fast.d - height);  // the ray from the camera (at height d) crosses height 0 here
      const bool crosses = scale > 0 && grid.cell(foot.x() * scale, foot.y() * scale, cell);
      if (behind) {
        if (crosses) mark.seen_through(cell) = 255;
      } else {
        if (crosses) mark.covered(cell) = 255;
        if (!grid.cell(foot.x(), foot.y(), cell)) return;
        mark.covered(cell) = 255;
        if (height < kFootHeightM) mark.feet(cell) = 255;
      }
    });
  });
  grid.on_plane = marks[0].on_plane, grid.seen_through = marks[0].seen_through, grid.covered = marks[0].covered;
  grid.feet = marks[0].feet;
  for (int band = 1; band < bands; ++band) {
    grid.on_plane |= marks[band].on_plane;
    grid.seen_through |= marks[band].seen_through;
    grid.covered |= marks[band].covered;
    grid.feet |= marks[band].feet;
  }
  grid.seen_through.setTo(0, grid.on_plane);
  return grid;
}

cv::Mat_<uchar> extentOf(const PlaneGrid& grid) {
  cv::Mat_<uchar> solid;
  cv::morphologyEx(grid.on_plane, solid, cv::MORPH_CLOSE, square(kBridgedGapM / 2, grid.cell_m));
  cv::morphologyEx(solid, solid, cv::MORPH_OPEN, square(kSpeckM / 2, grid.cell_m));
  solid = withoutSmallParts(solid, kMinPartM2 / (grid.cell_m * grid.cell_m));

  // Bridge what things cover. The grid has an empty rim as wide as the reach, so that its border sticks to nothing.
  cv::Mat_<uchar> core, rim, reachable;
  cv::morphologyEx(solid, core, cv::MORPH_CLOSE, square(kBridgedThingM / 2, grid.cell_m));
  core = solid | (core & grid.covered);
  cv::morphologyEx(core, core, cv::MORPH_CLOSE, square(kBridgedGapM / 2, grid.cell_m));
  core.setTo(0, grid.seen_through);
  core = fillHoles(mainPart(core, solid));

  const int rim_cells = std::max(1, static_cast<int>(std::lround(kRimM / grid.cell_m)));
  cv::dilate(core, rim, cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * rim_cells + 1, 2 * rim_cells + 1)));
  cv::dilate(core, reachable, square(kReachM, grid.cell_m));
  cv::Mat_<uchar> all = rim | (reachable & grid.covered);
  all.setTo(0, grid.seen_through);
  cv::Mat_<uchar> extent = fillHoles(mainPart(all | core, core)) & TableExtent::kMargin;
  extent.setTo(TableExtent::kCore, core);
  return extent;
}

void markBeyond(const PlaneGrid& grid, cv::Mat_<uchar>& extent) {
  cv::Mat_<uchar> all_feet = grid.feet & (extent == 0);
  if (cv::countNonZero(all_feet) == 0) return;
  // No way to them and nothing around them reaches out of this part of the grid.
  const int margin = static_cast<int>(std::lround((kBeyondM + kClearOfThroughM) / grid.cell_m)) + 1;
  cv::Rect part = cv::boundingRect(all_feet);
  part = cv::Rect(part.tl() - cv::Point(margin, margin), part.br() + cv::Point(margin, margin)) &
         cv::Rect(0, 0, grid.columns, grid.rows);
  const cv::Mat_<uchar> own = extent(part) > 0, seen_through = grid.seen_through(part).clone();
  const cv::Mat step = square(kClearOfThroughM, grid.cell_m);
  cv::Mat_<uchar> through, feet = all_feet(part);
  cv::dilate(seen_through, through, step);

  // The way to them, in steps that do not reach over what is seen through and as much on each of its sides.
  cv::Mat_<uchar> reached = own.clone(), wider;
  for (double way_m = 0; way_m < kBeyondM; way_m += kClearOfThroughM) {
    cv::dilate(reached, wider, step);
    reached |= wider & ~through;
  }
  feet = withoutSmallParts(feet & reached & ~through, kMinFootCells);
  cv::Mat_<uchar> around, things;
  cv::dilate(feet, around, square(kReachM, grid.cell_m));
  things = around & grid.covered(part);
  cv::dilate(things, things, square(kBridgedGapM, grid.cell_m));
  extent(part).setTo(TableExtent::kBeyond, things & ~seen_through & ~own);
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/table.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <sstream>

#include "common/parallel.hpp"
#include "scene/depth_noise.hpp"
#include "scene/plane_grid.hpp"
#include "scene/plane_hypotheses.hpp"
#include "scene/support_layer.hpp"
#include "scene/table_choice.hpp"
#include "scene/table_outline.hpp"

namespace objectness {
namespace {

constexpr int kSampleCount = 40000;         // to find planes in
constexpr int kExtentSampleCount = 120000;  // to draw the extent from
constexpr double kExtentCellM = 0.01;

/// A plane and, if it was searched for, its evidence.
struct TablePlane {
  Plane plane;
  SeenPlane seen;
};

Result<TablePlane> givenPlane(const TableConfig& config) {
  const Eigen::Vector3d normal(config.given_a, config.given_b, config.given_c);
  const double length = normal.norm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(config.given_d)) {
    return Result<TablePlane>::error(
        StatusCode::kBadConfig,
        "table.given is set but (given_a, given_b, given_c) is no direction: give the plane's normal");
  }
  Plane plane{normal / length, config.given_d / length};
  if (plane.d < 0) plane.normal = -plane.normal, plane.d = -plane.d;
  return {{}, {plane, {}}};
}

/// The best table among the planes.
Result<TablePlane> choosePlane(const SurfaceSamples& samples, double focal, const std::vector<Plane>& planes,
                               const TableConfig& config, int threads) {
  const Eigen::Vector3d up(config.up_x, config.up_y, config.up_z);
  if (config.up_known && !(up.norm() > 0)) {
    return Result<TablePlane>::error(StatusCode::kBadConfig,
                                     "table.up_known is set but (up_x, up_y, up_z) has no length");
  }
  TableChoice choice(samples, focal, planes, config);
  const int best = choice.best(threads);
  if (best >= 0) return {{}, {planes[best], choice.seen(best)}};

  const auto valid =
      std::count_if(samples.samples.begin(), samples.samples.end(), [](const auto& s) { return s.valid(); });
  std::ostringstream why;
  why << "no table in view: "
      << static_cast<int>(100.0 * valid / std::max<std::size_t>(1, samples.samples.size()) + 0.5)
      << " % of the pixels have depth, " << planes.size() << " planes were found";
  const int tilted = choice.tilted();
  if (tilted > 0) why << ", " << tilted << " of them tilted more than table.max_tilt_deg";
  if (tilted < static_cast<int>(planes.size())) {
    why << ", the largest of " << std::round(choice.largest_m2() * 1e4) << " cm2 (table.min_area_m2 asks for "
        << std::round(config.min_area_m2 * 1e4) << " cm2)";
  }
  return Result<TablePlane>::error(StatusCode::kNoTable, why.str());
}

std::vector<Plane> otherPlanes(const std::vector<Plane>& planes, const Plane& table) {
  constexpr double kSameDistanceM = 0.02, kSameCosine = 0.9945;
  std::vector<Plane> others;
  for (const Plane& plane : planes) {
    const bool same = plane.normal.dot(table.normal) > kSameCosine && std::abs(plane.d - table.d) < kSameDistanceM;
    if (!same) others.push_back(plane);
  }
  return others;
}

}  // namespace

Result<Table> findTable(const Frame& frame, const Normals& normals, const TableConfig& config, int threads) {
  const DepthNoise prior;
  const SurfaceSamples samples = sampleSurface(frame, normals, prior, kSampleCount, threads);
  const std::vector<Plane> planes = findPlanes(samples, threads);

  const Result<TablePlane> chosen =
      config.given ? givenPlane(config) : choosePlane(samples, frame.camera.focal(), planes, config, threads);
  if (!chosen.ok()) return Result<Table>::error(chosen.status);
  Plane plane = chosen.value.plane;
  SurfaceSamples dense;
  inParallel(
      threads,
      [&] {
        if (!config.given) plane = settleOnSupportLayer(samples, plane, chosen.value.seen);
      },
      [&] { dense = sampleSurface(frame, normals, prior, kExtentSampleCount, threads); });
  const PlaneGrid grid = makePlaneGrid(dense, plane, kExtentCellM, threads);
  if (grid.empty()) {
    return Result<Table>::error(StatusCode::kNoTable, config.given
                                                          ? "no point of the view lies on the given table plane"
                                                          : "no point of the view lies on the table plane");
  }
  const cv::Mat_<uchar> extent = extentOf(grid);
  if (cv::countNonZero(extent) == 0) {
    return Result<Table>::error(StatusCode::kNoTable, "only specks of the table plane are in view");
  }
  Table table;
  table.normal = plane.normal;
  table.d = plane.d;
  table.T_table_camera = grid.T_table_camera;
  table.extent = {extent, grid.origin, grid.cell_m};
  table.noise = measureNoise(dense, plane, grid, extent, threads);
  markBeyond(grid, table.extent.cells);
  traceOutline(frame, table);
  table.other_planes = otherPlanes(planes, plane);
  return {{}, table};
}

}  // namespace objectness

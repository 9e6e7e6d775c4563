// SPDX-License-Identifier: BSD-3-Clause
#include "scene/refined_normals.hpp"

#include <algorithm>
#include <cmath>

#include "common/upper_median.hpp"
#include "scene/plane_grid.hpp"
#include "scene/sampled_values.hpp"

namespace objectness {
namespace {

constexpr int kStride = 7;  // every so many pixels are plenty for a median
constexpr std::size_t kMinSamples = 100;
constexpr float kOnTableSigmas = 2.0f;  // nearer to the plane than this is table
constexpr float kOnTableM = 0.003f;

}  // namespace

double tableNormalError(const Frame& frame, const Normals& normals, const Table& table, int threads) {
  const Eigen::Vector3f up = table.normal.cast<float>();
  const Eigen::Matrix<double, 2, 3> axes = table.T_table_camera.linear().topRows<2>();
  std::vector<float> cosines = sampledValues(frame.size(), kStride, threads, [&](int i, std::vector<float>& values) {
    if (normals.radius_px[i] == 0) return;
    const Eigen::Vector3f& p = frame.points[i];
    const double tolerance = std::max<double>(kOnTableM, kOnTableSigmas * table.noise.sigma(p.z()));
    if (std::abs(table.height(p)) > tolerance) return;
    const Eigen::Vector2d foot = axes * p.cast<double>();
    if (table.extent.at(foot.x(), foot.y()) == TableExtent::kCore) values.push_back(normals.normal[i].dot(up));
  });
  if (cosines.size() < kMinSamples) return 0;
  return std::acos(std::clamp(upperMedian(cosines), -1.f, 1.f)) * 180 / M_PI;
}

Normals refineNormals(const Frame& frame, Normals normals, const Table& table, const NormalsConfig& config,
                      int threads) {
  const double error = tableNormalError(frame, normals, table, threads);
  const double widening = std::min(config.max_widening, error / config.max_error_deg);
  if (widening <= 1) return normals;
  NormalsConfig wider = config;
  wider.window_m *= widening;
  return estimateNormals(frame, wider, table.noise, threads);
}

}  // namespace objectness

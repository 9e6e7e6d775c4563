// SPDX-License-Identifier: BSD-3-Clause
#include "scene/depth_noise.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/parallel.hpp"

namespace objectness {
namespace {

constexpr float kBinM = 0.1f;
constexpr std::size_t kMinPerBin = 50;
constexpr double kOneSigma = 0.683;                             // share of a normal distribution within one sigma
constexpr float kMaxResidualM = 0.06f;                          // deeper is another surface, not noise
constexpr double kMinQuadratic = 0.0003, kMaxQuadratic = 0.02;  // per metre; the range of known depth cameras

}  // namespace

DepthNoise measureNoise(const SurfaceSamples& view, const Plane& plane, const PlaneGrid& grid,
                        const cv::Mat_<uchar>& extent, int threads) {
  using Residuals = std::map<int, std::vector<float>>;  // by depth
  constexpr int kParts = 8;
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = grid.T_table_camera.linear().topRows<2>().cast<float>();
  Residuals parts[kParts];
  parallelFor(kParts, threads, [&](int part) {
    const std::size_t size = view.samples.size();
    cv::Point cell;
    for (std::size_t i = size * part / kParts; i < size * (part + 1) / kParts; ++i) {
      const auto& sample = view.samples[i];
      if (!sample.valid()) continue;
      const float height = fast.height(sample.point);
      if (height > 0) continue;
      const float z_on_plane = sample.point.z() * fast.d / (fast.d - height);
      const float residual = sample.point.z() - z_on_plane;
      if (residual > kMaxResidualM) continue;
      const Eigen::Vector2f foot = axes * sample.point;
      if (grid.cell(foot.x(), foot.y(), cell) && extent(cell) == TableExtent::kCore) {
        parts[part][static_cast<int>(z_on_plane / kBinM)].push_back(residual);
      }
    }
  });
  Residuals residuals;
  for (const Residuals& part : parts) {
    for (const auto& [bin, values] : part) {
      residuals[bin].insert(residuals[bin].end(), values.begin(), values.end());
    }
  }

  struct Bin {
    double z, sigma, weight;
  };
  std::vector<Bin> bins;
  for (auto& entry : residuals) {
    std::vector<float>& values = entry.second;
    if (values.size() < kMinPerBin) continue;
    const auto quantile = values.begin() + static_cast<std::size_t>(kOneSigma * values.size());
    std::nth_element(values.begin(), quantile, values.end());
    bins.push_back({(entry.first + 0.5) * kBinM, *quantile, double(values.size())});
  }
  DepthNoise noise;
  if (bins.empty()) return noise;
  // One view rarely spans the depths to tell the two terms apart: the constant one, mostly rounding, stays the prior's.
  for (const Bin& bin : bins) noise.constant_m = std::min(noise.constant_m, bin.sigma);
  double sum = 0, weights = 0;
  for (const Bin& bin : bins) {
    sum += bin.weight * (bin.sigma - noise.constant_m) / (bin.z * bin.z);
    weights += bin.weight;
  }
  noise.quadratic_per_m = std::min(kMaxQuadratic, std::max(kMinQuadratic, sum / weights));
  return noise;
}

}  // namespace objectness

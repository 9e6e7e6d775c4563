// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "depth_jumps.hpp"
#include "normals_pcl.hpp"

namespace objectness {
namespace {

// Inverse depth in fixed point, so that integral images are exact: a step of 2^-20 / m is 1 um at 1 m, 36 um at 6 m.
constexpr double kScale = 1048576.0;
constexpr float kMaxInverseDepth = 100.0f;  // 1 cm; keeps the sums of a window of 101 x 101 squares within 64 bits

/// Sums over all pixels above and left. They wrap around in large images; differences of them do not.
struct Sums {
  std::uint64_t w = 0, uw = 0, vw = 0, ww = 0;
};

/// The rows of an integral image that windows of a given radius around the current row can reach.
class IntegralRows {
 public:
  IntegralRows(const Frame& frame, int max_radius)
      : frame_(frame), rows_(2 * max_radius + 2), stride_(frame.width() + 1), sums_(std::size_t(rows_) * stride_) {}

  /// Entry u holds the sums of the pixels (x < u, y < v).
  const Sums* row(int v) const { return sums_.data() + std::size_t(v % rows_) * stride_; }

  /// Makes row(v) available for v up to `last`; must be called with rising values.
  void advance(int last) {
    for (last = std::min(last, frame_.height()); next_ <= last; ++next_) fillRow(next_);
  }

 private:
  void fillRow(int v) {
    const Sums* above = row(v - 1);
    Sums* current = sums_.data() + std::size_t(v % rows_) * stride_;
    const Eigen::Vector3f* points = frame_.points.data() + std::size_t(v - 1) * frame_.width();
    Sums line;
    for (int u = 0; u < frame_.width(); ++u) {
      const float z = points[u].z();
      const auto w = z > 0 ? static_cast<std::uint64_t>(kScale * std::min(1.0f / z, kMaxInverseDepth) + 0.5) : 0;
      line.w += w;
      line.uw += w * static_cast<std::uint64_t>(u);
      line.vw += w * static_cast<std::uint64_t>(v - 1);
      line.ww += w * w;
      current[u + 1] = {above[u + 1].w + line.w, above[u + 1].uw + line.uw, above[u + 1].vw + line.vw,
                        above[u + 1].ww + line.ww};
    }
    current[0] = {};
  }

  const Frame& frame_;
  int rows_, stride_;
  int next_ = 1;
  std::vector<Sums> sums_;
};

Sums windowSums(const IntegralRows& rows, int u, int v, int radius) {
  const Sums *top = rows.row(v - radius), *bottom = rows.row(v + radius + 1);
  const int left = u - radius, right = u + radius + 1;
  return {bottom[right].w - bottom[left].w - top[right].w + top[left].w,
          bottom[right].uw - bottom[left].uw - top[right].uw + top[left].uw,
          bottom[right].vw - bottom[left].vw - top[right].vw + top[left].vw,
          bottom[right].ww - bottom[left].ww - top[right].ww + top[left].ww};
}

struct PlaneFit {
  Eigen::Vector3f normal;
  float residual_m, depth_m;
};

/// 1/z = a (u - u0) + b (v - v0) + c over the full window around (u0, v0).
PlaneFit fitPlane(const PinholeCamera& camera, const Sums& sums, int u, int v, int radius) {
  const double n = (2 * radius + 1) * (2 * radius + 1);
  const double second_moment = n * radius * (radius + 1) / 3.0;  // sum of (u - u0)^2 over the window
  const double sum_uw =
      static_cast<double>(static_cast<std::int64_t>(sums.uw - sums.w * static_cast<std::uint64_t>(u)));
  const double sum_vw =
      static_cast<double>(static_cast<std::int64_t>(sums.vw - sums.w * static_cast<std::uint64_t>(v)));
  const double a = sum_uw / second_moment, b = sum_vw / second_moment, c = static_cast<double>(sums.w) / n;

  // u = fx x/z + cx turns the fit into (a fx) x + (b fy) y + (a (cx - u0) + b (cy - v0) + c) z = 1: away from the
  // camera.
  const Eigen::Vector3d away(a * camera.fx, b * camera.fy, a * (camera.cx - u) + b * (camera.cy - v) + c);
  const double norm = away.norm();
  const double variance =
      std::max(0.0, (static_cast<double>(sums.ww) - c * static_cast<double>(sums.w) - a * sum_uw - b * sum_vw) / n);
  const double z = kScale / c;
  const double depth_residual = std::sqrt(variance) / kScale * z * z;
  return {(-away / norm).cast<float>(), static_cast<float>(depth_residual * c / norm), static_cast<float>(z)};
}

}  // namespace

Normals estimateNormals(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise) {
  const int width = frame.width(), height = frame.height();
  const std::size_t size = static_cast<std::size_t>(frame.size());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Normals normals;
  normals.normal.assign(size, Eigen::Vector3f(nan, nan, nan));
  normals.residual_m.assign(size, nan);
  normals.depth_m.assign(size, nan);
  normals.radius_px.assign(size, 0);
  normals.jump = findDepthJumps(frame, config, noise);
  const cv::Mat_<uchar> clear = clearRadius(frame, normals.jump);

  const int max_radius = std::max(config.min_window_px, config.max_window_px);
  const float window = static_cast<float>(config.window_m * frame.camera.focal());
  IntegralRows rows(frame, max_radius);
  for (int v = 0; v < height; ++v) {
    rows.advance(v + max_radius + 1);
    for (int u = 0; u < width; ++u) {
      if (clear(v, u) == 0) continue;
      const std::size_t i = static_cast<std::size_t>(v) * width + u;
      const int wanted = static_cast<int>(std::min(window / frame.points[i].z() + 0.5f, 255.0f));
      const int on_surface = std::max(config.min_window_px, std::min(wanted, config.max_window_px));
      const int radius = std::min<int>(on_surface, clear(v, u));
      const PlaneFit fit = fitPlane(frame.camera, windowSums(rows, u, v, radius), u, v, radius);
      if (!(fit.normal.dot(frame.points[i]) < 0)) continue;
      normals.normal[i] = fit.normal;
      normals.residual_m[i] = fit.residual_m;
      normals.depth_m[i] = fit.depth_m;
      normals.radius_px[i] = static_cast<unsigned char>(radius);
    }
  }
  if (config.pcl) replaceByPclNormals(frame, normals);
  return normals;
}

}  // namespace objectness

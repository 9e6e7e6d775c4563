// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/normals.hpp"

#include <algorithm>
#include <limits>

#include "common/row_bands.hpp"
#include "scene/depth_discontinuities.hpp"
#include "scene/integral_rows.hpp"
#include "scene/normal_fit_kernel.hpp"
#include "scene/normals_pcl.hpp"

namespace objectness {
namespace {

constexpr int kRowsPerBand = 80;  // every band sums the rows within reach above it once more

/// The windows of a row and the planes fitted to them, for pixels that have one.
class RowOfWindows {
 public:
  explicit RowOfWindows(int width)
      : column_(width), doubles_(6, std::vector<double>(width)), floats_(5, std::vector<float>(width)) {}

  void clear() { count_ = 0; }
  void add(int u, int radius, const InverseDepthSums& sums) {
    const int side = 2 * radius + 1;
    const double pixels = side * side;
    column_[count_] = u;
    doubles_[0][count_] = pixels;
    doubles_[1][count_] = pixels * radius * (radius + 1) / 3.0;
    doubles_[2][count_] = static_cast<double>(sums.w);
    doubles_[3][count_] = static_cast<double>(static_cast<std::int64_t>(sums.uw));
    doubles_[4][count_] = static_cast<double>(static_cast<std::int64_t>(sums.vw));
    doubles_[5][count_] = static_cast<double>(sums.ww);
    ++count_;
  }
  void fit(const PinholeCamera& camera, int row) {
    fitPlanesInRow({camera.fx, camera.fy, camera.cx, camera.cy}, row,
                   {column_.data(), doubles_[0].data(), doubles_[1].data(), doubles_[2].data(), doubles_[3].data(),
                    doubles_[4].data(), doubles_[5].data()},
                   count_,
                   {floats_[0].data(), floats_[1].data(), floats_[2].data(), floats_[3].data(), floats_[4].data()});
  }
  int count() const { return count_; }
  int column(int i) const { return column_[i]; }
  Eigen::Vector3f normal(int i) const { return {floats_[0][i], floats_[1][i], floats_[2][i]}; }
  float residual_m(int i) const { return floats_[3][i]; }
  float depth_m(int i) const { return floats_[4][i]; }

 private:
  int count_ = 0;
  std::vector<int> column_;
  std::vector<std::vector<double>> doubles_;
  std::vector<std::vector<float>> floats_;
};

/// Sets the window radius of the pixels in rows first..last-1, 0 where there is no window. Returns the largest.
int chooseWindows(const Frame& frame, const NormalsConfig& config, const cv::Mat_<uchar>& clear, int first, int last,
                  Normals& normals) {
  const float window = static_cast<float>(config.window_m * frame.camera.focal());
  int widest = 0;
  for (int v = first; v < last; ++v) {
    unsigned char* radius_px = normals.radius_px.data() + std::size_t(v) * frame.width();
    const Eigen::Vector3f* points = frame.points.data() + std::size_t(v) * frame.width();
    for (int u = 0; u < frame.width(); ++u) {
      if (clear(v, u) == 0) continue;
      const int wanted = static_cast<int>(std::min(window / points[u].z() + 0.5f, 255.0f));
      const int on_surface = std::max(config.min_window_px, std::min(wanted, config.max_window_px));
      const int radius = std::min<int>(on_surface, clear(v, u));
      radius_px[u] = static_cast<unsigned char>(radius);
      widest = std::max(widest, radius);
    }
  }
  return widest;
}

void fitRows(const Frame& frame, const NormalsConfig& config, const cv::Mat_<uchar>& clear, int first, int last,
             Normals& normals) {
  const int width = frame.width();
  const int widest = chooseWindows(frame, config, clear, first, last, normals);
  IntegralRows integral(frame, widest, first);
  RowOfWindows windows(width);
  for (int v = first; v < last; ++v) {
    integral.moveTo(v, widest);
    windows.clear();
    unsigned char* radius_px = normals.radius_px.data() + std::size_t(v) * width;
    const Eigen::Vector3f* points = frame.points.data() + std::size_t(v) * width;
    for (int u = 0; u < width; ++u) {
      if (radius_px[u] > 0) windows.add(u, radius_px[u], integral.window(u, v, radius_px[u]));
    }
    windows.fit(frame.camera, v);
    for (int i = 0; i < windows.count(); ++i) {
      const int u = windows.column(i);
      if (!(windows.normal(i).dot(points[u]) < 0)) {
        radius_px[u] = 0;
        continue;
      }
      const std::size_t pixel = std::size_t(v) * width + u;
      normals.normal[pixel] = windows.normal(i);
      normals.residual_m[pixel] = windows.residual_m(i);
      normals.depth_m[pixel] = windows.depth_m(i);
    }
  }
}

}  // namespace

Normals estimateNormals(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise, int threads) {
  const std::size_t size = static_cast<std::size_t>(frame.size());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Normals normals;
  normals.normal.assign(size, Eigen::Vector3f(nan, nan, nan));
  normals.residual_m.assign(size, nan);
  normals.depth_m.assign(size, nan);
  normals.radius_px.assign(size, 0);
  normals.jump = findDepthDiscontinuities(frame, config, noise, threads);
  const cv::Mat_<uchar> clear =
      clearRadius(frame, normals.jump, threads, std::max(config.min_window_px, config.max_window_px));
  forRowBands(
      frame.height(), threads, [&](int first, int last) { fitRows(frame, config, clear, first, last, normals); },
      kRowsPerBand);
  if (config.pcl) replaceByPclNormals(frame, normals);
  return normals;
}

}  // namespace objectness

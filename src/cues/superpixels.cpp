// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/superpixels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "crease.hpp"

namespace objectness {
namespace {

constexpr double kResidualFloor = 0.0012;  // metres; whole millimetres of depth leave about this much on any plane
constexpr double kMinGap = 0.004;          // metres
constexpr double kGapSigmas = 4.0;
constexpr int kTableStride = 5;  // every so many pixels are plenty for a median

/// The table's own fit residual per z^2, metres: it holds the noise of this sensor in this frame.
double tableResidual(const Frame& frame, const Normals& normals, const ObjectPoints& object_points) {
  std::vector<float> residuals;
  for (int i = 0; i < frame.size(); i += kTableStride) {
    const float z = frame.points[i].z();
    if (object_points.on_table(i) && normals.radius_px[i] > 0) residuals.push_back(normals.residual_m[i] / (z * z));
  }
  if (residuals.empty()) return 0;
  const auto middle = residuals.begin() + residuals.size() / 2;
  std::nth_element(residuals.begin(), middle, residuals.end());
  return *middle;
}

/// Object points whose window is one smooth piece of surface: not fitted badly, not bent.
std::vector<uchar> smoothPixels(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                                const SuperpixelsConfig& config) {
  const double max_residual = config.max_residuals * tableResidual(frame, normals, object_points);
  const double max_concave = bendOf(config.concave_deg), max_convex = bendOf(config.convex_deg);
  const BendMap bends = findBends(frame, normals, object_points.mask);
  std::vector<uchar> smooth(frame.size(), 0);
  for (int i = 0; i < frame.size(); ++i) {
    if (!object_points.mask(i) || normals.radius_px[i] < kMinWindowPx) continue;
    const double z = frame.points[i].z();
    smooth[i] = normals.residual_m[i] <= std::max(kResidualFloor, max_residual * z * z) &&
                bends.concave(i) <= max_concave && bends.convex(i) <= max_convex;
  }
  return smooth;
}

class Grower {
 public:
  Grower(const Frame& frame, const Normals& normals, const DepthNoise& noise, const SuperpixelsConfig& config)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        config_(config),
        min_cosine_(static_cast<float>(std::cos(config.neighbor_deg * M_PI / 180))) {}

  /// The connected component of `open` around a seed, 8 neighbours; it is closed on the way.
  const std::vector<int>& grow(int seed, std::vector<uchar>& open) {
    const int width = frame_.width();
    open[seed] = 0;
    piece_.assign(1, seed);
    for (std::size_t next = 0; next < piece_.size(); ++next) {
      const int pixel = piece_[next], u = pixel % width, v = pixel / width;
      for (int y = std::max(0, v - 1); y <= std::min(frame_.height() - 1, v + 1); ++y) {
        for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
          const int other = y * width + x;
          if (!open[other] || !connected(pixel, other)) continue;
          open[other] = 0;
          piece_.push_back(other);
        }
      }
    }
    return piece_;
  }

  bool largeEnough(const std::vector<int>& piece) const {
    if (static_cast<int>(piece.size()) < config_.min_pixels) return false;
    double area = 0;  // as seen: a pixel spans (z / f)^2
    for (const int pixel : piece) area += frame_.points[pixel].z() * frame_.points[pixel].z();
    return area / (frame_.camera.fx * frame_.camera.fy) >= config_.min_area_m2;
  }

 private:
  bool connected(int a, int b) const {
    if (!(normals_.normal[a].dot(normals_.normal[b]) > min_cosine_)) return false;
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z(), z = std::min(z_a, z_b);
    const double step = std::abs(z_a - z_b);
    return step < kMinGap || step < std::max(kGrazingSlope * z / frame_.camera.focal(), kGapSigmas * noise_.sigma(z));
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const SuperpixelsConfig& config_;
  const float min_cosine_;
  std::vector<int> piece_;
};

}  // namespace

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config) {
  Superpixels superpixels{cv::Mat_<int>::zeros(frame.height(), frame.width()), 0};
  std::vector<uchar> open = smoothPixels(frame, normals, object_points, config);
  Grower grower(frame, normals, table.noise, config);
  for (int seed = 0; seed < frame.size(); ++seed) {
    if (!open[seed]) continue;
    const std::vector<int>& piece = grower.grow(seed, open);
    if (!grower.largeEnough(piece)) continue;
    ++superpixels.count;
    for (const int pixel : piece) superpixels.label(pixel) = superpixels.count;
  }
  return superpixels;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/superpixels.hpp"

#include "crease.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace objectness {
namespace {

constexpr double kResidualFloor = 0.0012;  // metres; whole millimetres of depth leave about this much on any plane
constexpr double kMinGap = 0.004;          // metres
constexpr double kGapSigmas = 4.0;
constexpr double kGrazingSlope = 8.0;  // depth change per z / f of a surface seen at about 83 deg

/// What is smooth enough to be one surface.
struct Smoothness {
  double concave_deg, convex_deg;  ///< sharper bends cut
  double residual;                 ///< largest fit residual, in multiples of the table's own
  double neighbor_deg;             ///< largest angle between the normals of neighbouring pixels
};

/// The table's own fit residual per z^2 is the unit of the residual gate: it holds the noise of this sensor, this frame.
double tableResidual(const Frame& frame, const Normals& normals, const ObjectPoints& object_points) {
  std::vector<float> residuals;
  for (int i = 0; i < frame.size(); ++i) {
    const float z = frame.points[i].z();
    if (object_points.on_table(i) && normals.radius_px[i] > 0) residuals.push_back(normals.residual_m[i] / (z * z));
  }
  if (residuals.empty()) return 0;
  const auto middle = residuals.begin() + residuals.size() / 2;
  std::nth_element(residuals.begin(), middle, residuals.end());
  return *middle;
}

class Grower {
 public:
  Grower(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
         const SuperpixelsConfig& config)
      : frame_(frame), normals_(normals), noise_(table.noise), config_(config), mask_(object_points.mask),
        bends_(findBends(frame, normals, object_points.mask)),
        table_residual_(tableResidual(frame, normals, object_points)),
        label_(cv::Mat_<int>::zeros(frame.height(), frame.width())) {}

  /// Grows superpixels over what has no label yet. Pixels beside an earlier superpixel stay out: they are its rim.
  void grow(const Smoothness& smoothness) {
    std::vector<uchar> open = openPixels(smoothness);
    const float min_cosine = static_cast<float>(std::cos(smoothness.neighbor_deg * M_PI / 180));
    std::vector<int> piece;
    for (int seed = 0; seed < frame_.size(); ++seed) {
      if (!open[seed]) continue;
      open[seed] = 0;
      piece.assign(1, seed);
      for (std::size_t next = 0; next < piece.size(); ++next) {
        forEachNeighbor(piece[next], [&](int other) {
          if (!open[other] || !connected(piece[next], other, min_cosine)) return;
          open[other] = 0;
          piece.push_back(other);
        });
      }
      if (!largeEnough(piece)) continue;
      ++count_;
      for (const int pixel : piece) label_(pixel) = count_;
    }
  }

  /// Numbers 1, 2, ... in the order of the first pixel of each, row by row.
  Superpixels numbered() {
    std::vector<int> number(count_ + 1, 0);
    int numbers = 0;
    for (int& label : label_) {
      if (label == 0) continue;
      if (number[label] == 0) number[label] = ++numbers;
      label = number[label];
    }
    return {label_, count_};
  }

 private:
  template <class Visit>
  void forEachNeighbor(int pixel, Visit&& visit) const {
    const int width = frame_.width(), u = pixel % width, v = pixel / width;
    for (int y = std::max(0, v - 1); y <= std::min(frame_.height() - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
        if (x != u || y != v) visit(y * width + x);
      }
    }
  }

  std::vector<uchar> openPixels(const Smoothness& smoothness) const {
    const double max_concave = bendOf(smoothness.concave_deg), max_convex = bendOf(smoothness.convex_deg);
    std::vector<uchar> open(frame_.size(), 0);
    for (int i = 0; i < frame_.size(); ++i) {
      if (!mask_(i) || label_(i) || normals_.radius_px[i] == 0) continue;
      const double z = frame_.points[i].z();
      if (normals_.residual_m[i] > std::max(kResidualFloor, smoothness.residual * table_residual_ * z * z)) continue;
      if (bends_.concave(i) > max_concave || bends_.convex(i) > max_convex) continue;
      bool beside_earlier = false;
      if (count_ > 0) forEachNeighbor(i, [&](int other) { beside_earlier |= label_(other) > 0; });
      open[i] = !beside_earlier;
    }
    return open;
  }

  bool connected(int a, int b, float min_cosine) const {
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z(), z = std::min(z_a, z_b);
    const double gap = std::max({kMinGap, kGrazingSlope * z / frame_.camera.focal(), kGapSigmas * noise_.sigma(z)});
    return std::abs(z_a - z_b) < gap && normals_.normal[a].dot(normals_.normal[b]) > min_cosine;
  }

  bool largeEnough(const std::vector<int>& piece) const {
    if (static_cast<int>(piece.size()) < config_.min_pixels) return false;
    double area = 0;  // as seen: a pixel spans (z / f)^2
    for (const int pixel : piece) area += frame_.points[pixel].z() * frame_.points[pixel].z();
    return area / (frame_.camera.fx * frame_.camera.fy) >= config_.min_area_m2;
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const SuperpixelsConfig& config_;
  const cv::Mat_<uchar>& mask_;
  const BendMap bends_;
  const double table_residual_;
  cv::Mat_<int> label_;
  int count_ = 0;
};

}  // namespace

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config) {
  Grower grower(frame, normals, table, object_points, config);
  grower.grow({30, 70, 5, 6});
  grower.grow({30, 70, 10, 12});
  return grower.numbered();
}

}  // namespace objectness

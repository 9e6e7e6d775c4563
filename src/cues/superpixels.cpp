// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/superpixels.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
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

double tableStep(const Frame& frame, const Normals& normals, const ObjectPoints& object_points) {
  std::vector<float> steps;
  for (int i = 0; i < frame.size(); i += kTableStride) {
    const float z = frame.points[i].z();
    if (object_points.on_table(i) && normals.radius_px[i] > 0) steps.push_back(stepAt(frame, normals, object_points.on_table, i % frame.width(), i / frame.width()) / (z * z));
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + steps.size() / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Object points whose window is one smooth piece of surface: not fitted badly, not bent.
std::vector<uchar> smoothPixels(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                                const SuperpixelsConfig& config) {
  const double max_residual = config.max_residuals * tableResidual(frame, normals, object_points);
  const double max_concave = bendOf(config.concave_deg), max_convex = bendOf(config.convex_deg);
  const BendMap bends = findBends(frame, normals, object_points.mask);
  std::vector<uchar> smooth(frame.size(), 0);
  const double max_step = config.max_steps * tableStep(frame, normals, object_points);
  for (int i = 0; i < frame.size(); ++i) {
    if (!object_points.mask(i) || normals.radius_px[i] < kMinWindowPx) continue;
    const double z = frame.points[i].z();
    smooth[i] = normals.residual_m[i] <= std::max(kResidualFloor, max_residual * z * z) &&
                bends.concave(i) <= max_concave && bends.convex(i) <= max_convex &&
                stepAt(frame, normals, object_points.mask, i % frame.width(), i / frame.width()) <= std::max(config.min_step_m, max_step * z * z);
  }
  return smooth;
}

/// Grows pieces from their middles outwards. Where two of them meet, they become one unless the place is narrow beside
/// both of them: a cut that the noise has left open somewhere still holds.
class Grower {
 public:
  Grower(const Frame& frame, const Normals& normals, const DepthNoise& noise, const SuperpixelsConfig& config)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        config_(config),
        min_cosine_(static_cast<float>(std::cos(config.neighbor_deg * M_PI / 180))) {}

  /// smooth: pixels that may belong to a piece. Returns the root of each pixel's piece; -1 for others.
  std::vector<int> grow(const cv::Mat_<uchar>& smooth) {
    cv::Mat_<float> room;  // to the nearest cut, pixels
    cv::distanceTransform(smooth, room, cv::DIST_L2, 3);
    std::vector<int> order;
    for (int i = 0; i < frame_.size(); ++i) {
      if (smooth(i)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return room(a) > room(b); });
    parent_.assign(frame_.size(), -1);
    pieces_.assign(frame_.size(), {});
    for (const int pixel : order) add(pixel, room(pixel));
    for (const int pixel : order) parent_[pixel] = root(pixel);
    return parent_;
  }

  bool largeEnough(int root) const {
    const Piece& piece = pieces_[root];
    return piece.pixels >= config_.min_pixels &&
           piece.area / (frame_.camera.fx * frame_.camera.fy) >= config_.min_area_m2;
  }

 private:
  struct Piece {
    int pixels = 0;
    double area = 0;  ///< as seen: a pixel spans (z / f)^2; here without 1 / f^2
    float room = 0;   ///< in its middle
  };

  void add(int pixel, float room) {
    const int width = frame_.width(), u = pixel % width, v = pixel / width;
    parent_[pixel] = pixel;
    const double z = frame_.points[pixel].z();
    pieces_[pixel] = {1, z * z, room};
    for (int y = std::max(0, v - 1); y <= std::min(frame_.height() - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
        const int other = y * width + x;
        if (other == pixel || parent_[other] < 0 || !connected(pixel, other)) continue;
        const int a = root(pixel), b = root(other);
        if (a == b || narrow(a, b, room)) continue;
        const int to = std::min(a, b), from = std::max(a, b);
        parent_[from] = to;
        pieces_[to].pixels += pieces_[from].pixels;
        pieces_[to].area += pieces_[from].area;
        pieces_[to].room = std::max(pieces_[to].room, pieces_[from].room);
      }
    }
  }

  bool narrow(int a, int b, float room) const {
    return room < config_.narrow_share * std::min(pieces_[a].room, pieces_[b].room) && largeEnough(a) && largeEnough(b);
  }

  int root(int pixel) {
    while (parent_[pixel] != pixel) pixel = parent_[pixel] = parent_[parent_[pixel]];
    return pixel;
  }

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
  std::vector<int> parent_;  ///< -1: not in a piece
  std::vector<Piece> pieces_;  ///< valid at roots
};

}  // namespace

Superpixels findSuperpixels(const Frame& frame, const Normals& normals, const Table& table,
                            const ObjectPoints& object_points, const SuperpixelsConfig& config) {
  Superpixels superpixels{cv::Mat_<int>::zeros(frame.height(), frame.width()), 0};
  std::vector<uchar> open = smoothPixels(frame, normals, object_points, config);
  const cv::Mat_<uchar> smooth(frame.height(), frame.width(), open.data());
  Grower grower(frame, normals, table.noise, config);
  const std::vector<int> roots = grower.grow(smooth);
  std::vector<int> label(frame.size(), 0);  // of a root
  for (int i = 0; i < frame.size(); ++i) {
    const int root = roots[i];
    if (root < 0 || !grower.largeEnough(root)) continue;
    if (label[root] == 0) label[root] = ++superpixels.count;
    superpixels.label(i) = label[root];
  }
  return superpixels;
}

}  // namespace objectness

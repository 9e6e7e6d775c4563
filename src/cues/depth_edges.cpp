// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "crease.hpp"
#include "edge_detectors.hpp"

namespace objectness {
namespace {

constexpr uchar kContinues = kBorder << 1;  // working bit: the same surface, or another one, lies across the gap
constexpr int kNone = -1;

class DepthEdgeFinder {
 public:
  DepthEdgeFinder(const Frame& frame, const Normals& normals, const DepthNoise& noise, const EdgesConfig& config)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        config_(config),
        focal_(frame.camera.focal()),
        kinds_(cv::Mat_<uchar>::zeros(frame.height(), frame.width())) {}

  cv::Mat_<uchar> run() {
    const int width = frame_.width(), height = frame_.height();
    std::vector<int> above(width, kNone);  // last valid row of every column
    for (int v = 0; v < height; ++v) {
      int left = kNone;
      for (int u = 0; u < width; ++u) {
        if (!valid(v * width + u)) continue;
        const int pixel = v * width + u;
        if (left != kNone) compare(v * width + left, pixel, u - left);
        if (above[u] != kNone) compare(above[u] * width + u, pixel, v - above[u]);
        left = u;
        above[u] = v;
      }
    }
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) markBorder(u, v);
    }
    return kinds_;
  }

 private:
  bool valid(int pixel) const { return !std::isnan(frame_.points[pixel].z()); }

  /// The normal at the rim of a gap: of the nearest pixel away from it that has one; windows shrink to nothing there.
  Eigen::Vector3f normalAtRim(int pixel, int away) const {
    const int width = frame_.width(), u = pixel % width, v = pixel / width;
    const int room = away == -1 ? u : away == 1 ? width - 1 - u : away < 0 ? v : frame_.height() - 1 - v;
    for (int k = 0; k < std::min(room, kMinWindowPx); ++k) {
      if (normals_.radius_px[pixel + k * away] > 0) return normals_.normal[pixel + k * away];
    }
    return normals_.normal[pixel];
  }

  /// The points on either side of a gap are one surface when each lies near the tangent plane of the other: a slanted
  /// surface goes a long way in depth across a wide gap.
  bool onOneSurface(int a, int b, int steps, double tolerance) const {
    const int stride = (b - a) / steps;
    const Eigen::Vector3f gap = frame_.points[b] - frame_.points[a];
    return std::abs(normalAtRim(a, -stride).dot(gap)) < tolerance &&
           std::abs(normalAtRim(b, stride).dot(gap)) < tolerance;
  }

  /// a and b: valid pixels `steps` apart in a row or a column, nothing valid between them.
  void compare(int a, int b, int steps) {
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z();
    if (steps == 1 && std::abs(z_a - z_b) <= config_.step_m) return;
    const double near = std::min(z_a, z_b), difference = std::abs(z_a - z_b);
    if (steps > 1 && steps * near > config_.gap_m * focal_) return;
    if (difference > config_.step_m) {
      const double noise = config_.step_sigmas * noise_.sigma(near);
      const double step = std::max({config_.step_m, noise, kGrazingSlope * near / focal_});
      if (difference > step && !(steps > 1 && onOneSurface(a, b, steps, step))) {
        kinds_(z_a < z_b ? a : b) |= kOccluding;
        kinds_(z_a < z_b ? b : a) |= kOccluded;
      }
    }
    if (steps > 1) {
      kinds_(a) |= kContinues;
      kinds_(b) |= kContinues;
    }
  }

  void markBorder(int u, int v) {
    const int width = frame_.width(), pixel = v * width + u;
    uchar& kinds = kinds_(pixel);
    const bool in_question = !(kinds & (kOccluding | kOccluded | kContinues)) && valid(pixel);
    kinds &= ~kContinues;
    if (!in_question) return;
    const bool on_frame = u == 0 || v == 0 || u + 1 == width || v + 1 == frame_.height();
    if (on_frame || !valid(pixel - 1) || !valid(pixel + 1) || !valid(pixel - width) || !valid(pixel + width)) {
      kinds |= kBorder;
    }
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const EdgesConfig& config_;
  const double focal_;
  cv::Mat_<uchar> kinds_;
};

}  // namespace

cv::Mat_<uchar> findDepthEdges(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                               const EdgesConfig& config) {
  return DepthEdgeFinder(frame, normals, noise, config).run();
}

}  // namespace objectness

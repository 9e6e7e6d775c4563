// SPDX-License-Identifier: BSD-3-Clause
#include "crease.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace objectness {
namespace {

constexpr int kSmoothing = 5;  // pixels, less than the smallest window: takes the noise off the ridges, not the ridges

constexpr float kParallelCosine = 0.966f;  // 15 deg; across a bend one of the windows often sees some of it

/// Steps along a direction that are about `radius` pixels long.
int stepsOf(std::size_t direction, int radius) {
  const bool diagonal = direction >= 2;
  return diagonal ? (radius * 181 + 128) / 256 : radius;  // 181 / 256 = sqrt(1/2), rounded to whole steps
}

struct Sides {
  int a = -1, b = -1;
};

/// The pixels one window radius to either side of a pixel, or half of it where a jump makes the windows there smaller
/// than that: windows that overlap hide a bend, and tiny ones see only noise. Clear of the pixel: one pixel farther,
/// and as far along diagonals, so that neither of the square windows holds it. None: {-1, -1}.
Sides sidesOf(const Normals& normals, int width, int height, int u, int v, std::size_t direction, bool clear = false) {
  const int full = normals.radius_px[v * width + u];
  for (const int radius : {full, (full + 1) / 2}) {
    if (radius < kMinWindowPx) break;
    const int steps = clear ? radius + 1 : stepsOf(direction, radius);
    const int du = steps * kBendDirections[direction][0], dv = steps * kBendDirections[direction][1];
    if (u - du < 0 || u + du >= width || v - std::abs(dv) < 0 || v + std::abs(dv) >= height) continue;
    const int a = (v - dv) * width + u - du, b = (v + dv) * width + u + du;
    if (normals.radius_px[a] >= radius && normals.radius_px[b] >= radius) return {a, b};
  }
  return {};
}

/// The point of the fitted plane in the direction of a pixel.
Eigen::Vector3f onFit(const Frame& frame, const Normals& normals, int pixel) {
  return frame.points[pixel] * (normals.depth_m[pixel] / frame.points[pixel].z());
}

float strengthAt(const cv::Mat_<float>& strength, int u, int v) {
  const bool inside = u >= 0 && v >= 0 && u < strength.cols && v < strength.rows;
  return inside ? strength(v, u) : 0.f;
}

}  // namespace

float stepAt(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int u, int v) {
  float largest = 0;
  for (std::size_t i = 0; i < kBendDirections.size(); ++i) {
    const auto [a, b] = sidesOf(normals, frame.width(), frame.height(), u, v, i, true);
    if (a < 0 || !where(a) || !where(b)) continue;
    if (normals.normal[a].dot(normals.normal[b]) < kParallelCosine) continue;
    const Eigen::Vector3f between = onFit(frame, normals, b) - onFit(frame, normals, a);
    const float from_a = normals.normal[a].dot(between), from_b = normals.normal[b].dot(between);
    if (from_a * from_b > 0) largest = std::max(largest, std::min(std::abs(from_a), std::abs(from_b)));
  }
  return largest;
}

double bendOf(double angle_deg) { return 1.0 - std::cos(angle_deg * M_PI / 180.0); }

BendMap findBends(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where) {
  const int width = frame.width(), height = frame.height();
  BendMap bends{cv::Mat_<float>::zeros(height, width), cv::Mat_<float>::zeros(height, width),
                cv::Mat_<uchar>::zeros(height, width)};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const int pixel = v * width + u;
      if (!where(v, u) || normals.radius_px[pixel] == 0) continue;
      float& convex = bends.convex(v, u);
      float& concave = bends.concave(v, u);
      for (std::size_t i = 0; i < kBendDirections.size(); ++i) {
        const auto [a, b] = sidesOf(normals, width, height, u, v, i);
        if (a < 0) continue;
        const Eigen::Vector3f& n_a = normals.normal[a];
        const Eigen::Vector3f& n_b = normals.normal[b];
        const float bend = 1.f - n_a.dot(n_b);
        if (!(bend > std::min(convex, concave))) continue;
        const bool is_convex = (n_b - n_a).dot(frame.points[b] - frame.points[a]) > 0;
        if (bend > std::max(convex, concave)) bends.direction(v, u) = static_cast<uchar>(i);
        float& strongest = is_convex ? convex : concave;
        strongest = std::max(strongest, bend);
      }
    }
  }
  return bends;
}

cv::Mat_<uchar> thinCreases(const BendMap& bends, const Normals& normals, double min_angle_deg) {
  const int width = bends.convex.cols, height = bends.convex.rows;
  const float min_bend = static_cast<float>(bendOf(min_angle_deg));
  cv::Mat_<float> strength;
  cv::blur(cv::max(bends.convex, bends.concave), strength, {kSmoothing, kSmoothing});
  cv::Mat_<uchar> creases = cv::Mat_<uchar>::zeros(height, width);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const float own = strength(v, u);
      if (own < min_bend) continue;
      const int direction = bends.direction(v, u);
      const int steps = stepsOf(direction, normals.radius_px[v * width + u]);
      bool is_ridge = true;
      for (int k = 1; k <= (steps + 1) / 2 && is_ridge; ++k) {
        const int du = k * kBendDirections[direction][0], dv = k * kBendDirections[direction][1];
        is_ridge = own > strengthAt(strength, u - du, v - dv) && own >= strengthAt(strength, u + du, v + dv);
      }
      if (is_ridge) creases(v, u) = 255;
    }
  }
  return creases;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "cues/crease.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "common/row_bands.hpp"
#include "cues/bend_kernel.hpp"
#include "cues/side_runs.hpp"

namespace objectness {
namespace {

constexpr int kSmoothing = 5;  // pixels, less than the smallest window: takes the noise off the ridges, not the ridges

constexpr float kParallelCosine = 0.966f;  // 15 deg; across a bend one of the windows often sees some of it

/// The point of the fitted plane in the direction of a pixel.
Eigen::Vector3f onFit(const Frame& frame, const Normals& normals, int pixel) {
  return frame.points[pixel] * (normals.depth_m[pixel] / frame.points[pixel].z());
}

float strengthAt(const cv::Mat_<float>& strength, int u, int v) {
  const bool inside = u >= 0 && v >= 0 && u < strength.cols && v < strength.rows;
  return inside ? strength(v, u) : 0.f;
}

cv::Rect grown(const cv::Rect& rect, int margin, const cv::Size& image) {
  return cv::Rect(rect.x - margin, rect.y - margin, rect.width + 2 * margin, rect.height + 2 * margin) &
         cv::Rect({0, 0}, image);
}

void findBendsAt(const Frame& frame, const Normals& normals, int u, int v, BendMap& bends) {
  float& convex = bends.convex(v, u);
  float& concave = bends.concave(v, u);
  for (std::size_t i = 0; i < kBendDirections.size(); ++i) {
    const auto [a, b] = sidesOf(normals, frame.width(), frame.height(), u, v, i);
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

void findStepsInRows(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int first, int last,
                     cv::Mat_<float>& steps) {
  SideRuns runs(frame, normals, where);
  for (int v = first; v < last; ++v) {
    std::fill_n(steps[v], frame.width(), 0.f);
    runs.forEach(
        v, [&](int u) { steps(v, u) = stepAt(frame, normals, where, u, v); },
        [&](int u, int count) {
          const auto compare = [&](const Sides& sides, int x, int pixels, int radius, int, uchar* waiting) {
            stepRun(runs.sideAt(sides.a), runs.sideAt(sides.b), pixels, radius, kParallelCosine, waiting, steps[v] + x);
          };
          runs.compareSides(u, v, count, true, compare);
        });
  }
}

double bendOf(double angle_deg) { return 1.0 - std::cos(angle_deg * M_PI / 180.0); }

BendMap findBends(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int threads) {
  BendMap bends{cv::Mat_<float>(where.size()), cv::Mat_<float>(where.size()), cv::Mat_<uchar>(where.size())};
  forRowBands(frame.height(), threads, [&](int first, int last) {
    SideRuns runs(frame, normals, where);
    for (int v = first; v < last; ++v) {
      std::fill_n(bends.convex[v], frame.width(), 0.f);
      std::fill_n(bends.concave[v], frame.width(), 0.f);
      std::fill_n(bends.direction[v], frame.width(), uchar(0));
      runs.forEach(
          v, [&](int u) { findBendsAt(frame, normals, u, v, bends); },
          [&](int u, int count) {
            const auto compare = [&](const Sides& sides, int x, int pixels, int radius, int direction, uchar* waiting) {
              bendRun(runs.sideAt(sides.a), runs.sideAt(sides.b), pixels, radius, direction, waiting,
                      {bends.convex[v] + x, bends.concave[v] + x, bends.direction[v] + x});
            };
            runs.compareSides(u, v, count, false, compare);
          });
    }
  });
  return bends;
}

cv::Mat_<uchar> thinCreases(const BendMap& bends, const Normals& normals, const cv::Mat_<uchar>& where,
                            double min_angle_deg, int threads) {
  const int width = where.cols;
  const float min_bend = static_cast<float>(bendOf(min_angle_deg));
  cv::Mat_<uchar> creases(where.size(), uchar(0));
  const cv::Rect used = cv::boundingRect(where);
  if (used.empty()) return creases;
  const cv::Mat radius_px(where.size(), CV_8U, const_cast<uchar*>(normals.radius_px.data()));
  double widest_px = 0;
  cv::minMaxLoc(radius_px(used), nullptr, &widest_px);
  // Ridges are compared with what lies half a window away; bends are smoothed beyond that.
  const cv::Rect compared = grown(used, (static_cast<int>(widest_px) + 1) / 2, where.size());
  const cv::Rect smoothed = grown(compared, kSmoothing / 2, where.size());
  cv::Mat_<float> strength(where.size());
  const cv::Mat sharper = cv::max(bends.convex(smoothed), bends.concave(smoothed));
  cv::blur(sharper(compared - smoothed.tl()), strength(compared), {kSmoothing, kSmoothing});
  const auto isRidge = [&](int u, int v) {
    const float own = strength(v, u);
    if (own < min_bend) return false;
    const int direction = bends.direction(v, u);
    const int steps = stepsOf(direction, normals.radius_px[v * width + u]);
    for (int k = 1; k <= (steps + 1) / 2; ++k) {
      const int du = k * kBendDirections[direction][0], dv = k * kBendDirections[direction][1];
      if (own <= strengthAt(strength, u - du, v - dv) || own < strengthAt(strength, u + du, v + dv)) return false;
    }
    return true;
  };
  forRowBands(used.height, threads, [&](int first, int last) {
    for (int v = used.y + first; v < used.y + last; ++v) {
      for (int u = used.x; u < used.br().x; ++u) creases(v, u) = where(v, u) && isRidge(u, v) ? 255 : 0;
    }
  });
  return creases;
}

}  // namespace objectness

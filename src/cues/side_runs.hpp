// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "cues/bend_kernel.hpp"
#include "cues/crease.hpp"

namespace objectness {

/// Steps along a direction that are about `radius` pixels long.
inline int stepsOf(std::size_t direction, int radius) {
  const bool diagonal = direction >= 2;
  return diagonal ? (radius * 181 + 128) / 256 : radius;  // 181 / 256 = sqrt(1/2), rounded to whole steps
}

struct Sides {
  int a = -1, b = -1;
};

/// The pixels one window radius to either side of a pixel, or half of it where a jump makes the windows there smaller
/// than that: windows that overlap hide a bend, and tiny ones see only noise. `clear`: the windows leave out
/// the pixel itself (an offset of radius + 1 on every axis). {-1, -1}: none.
inline Sides sidesOf(const Normals& normals, int width, int height, int u, int v, std::size_t direction,
                     bool clear = false) {
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

/// Walks over rows in runs of pixels with windows of one size, whose sides lie next to each other, too: they are
/// compared many at a time.
class SideRuns {
 public:
  SideRuns(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where)
      : frame_(frame), normals_(normals), where_(where), waiting_(frame.width()) {}

  /// Calls one(u) for the pixels of short runs in row v and many(u, count) for the others; where `where` is not set or
  /// no normal is, neither.
  template <class One, class Many>
  void forEach(int v, One&& one, Many&& many) {
    const int width = frame_.width();
    const uchar* radius_px = normals_.radius_px.data() + std::size_t(v) * width;
    const uchar* where = where_[v];
    for (int u = 0; u < width;) {
      int end = u + 1;
      if (where[u] && radius_px[u] > 0) {
        while (end < width && where[end] && radius_px[end] == radius_px[u]) ++end;
        if (end - u < kShortRun) {
          for (int x = u; x < end; ++x) one(x);
        } else {
          many(u, end - u);
        }
      }
      u = end;
    }
  }

  /// Calls compare(sides, u, count, radius, direction, waiting) for the sides as of sidesOf() of a run, in every
  /// direction: sides of its first pixel u, and which of the pixels are still waiting for sides.
  template <class Compare>
  void compareSides(int u, int v, int count, bool clear, Compare&& compare) {
    const int width = frame_.width(), height = frame_.height(), full = normals_.radius_px[v * width + u];
    for (std::size_t direction = 0; direction < kBendDirections.size(); ++direction) {
      std::fill_n(waiting_.begin(), count, uchar(1));
      for (const int radius : {full, (full + 1) / 2}) {
        if (radius < kMinWindowPx) break;
        const int steps = clear ? radius + 1 : stepsOf(direction, radius);
        const int du = steps * kBendDirections[direction][0], dv = steps * kBendDirections[direction][1];
        const int first = std::max(u, du), last = std::min(u + count, width - du);
        if (first >= last || v - std::abs(dv) < 0 || v + std::abs(dv) >= height) continue;
        const Sides sides{(v - dv) * width + first - du, (v + dv) * width + first + du};
        compare(sides, first, last - first, radius, static_cast<int>(direction), waiting_.data() + first - u);
        if (!std::memchr(waiting_.data(), 1, static_cast<std::size_t>(count))) break;
      }
    }
  }

  SideRow sideAt(int pixel) const {
    return {normals_.normal[pixel].data(), frame_.points[pixel].data(), &normals_.depth_m[pixel],
            &normals_.radius_px[pixel], where_.data + pixel};
  }

 private:
  static constexpr int kShortRun = 8;

  const Frame& frame_;
  const Normals& normals_;
  const cv::Mat_<uchar>& where_;
  std::vector<uchar> waiting_;
};

}  // namespace objectness

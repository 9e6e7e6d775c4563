// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "objectness_segmentation/scene/frame.hpp"
#include "scene/normal_fit_kernel.hpp"

namespace objectness {

/// Sums of inverse depths w in fixed point, w times column and row, and w^2. They wrap around; differences of them do
/// not.
struct InverseDepthSums {
  std::uint64_t w = 0, uw = 0, vw = 0, ww = 0;
};

/// The rows of an integral image of inverse depths that square windows around the current row can reach.
class IntegralRows {
 public:
  /// For windows of rows from first_row on.
  IntegralRows(const Frame& frame, int max_radius, int first_row)
      : frame_(frame),
        rows_(2 * max_radius + 2),
        stride_(frame.width() + 1),
        next_(std::max(0, first_row - max_radius) + 1),
        sums_(std::size_t(rows_) * stride_) {}

  /// Makes the windows around row v available; v rises from call to call.
  void moveTo(int v, int max_radius) {
    for (const int last = std::min(v + max_radius + 1, frame_.height()); next_ <= last; ++next_) fill(next_);
  }

  /// Over the window of this radius around a pixel, columns and rows counted from it.
  InverseDepthSums window(int u, int v, int radius) const {
    const InverseDepthSums *top = row(v - radius), *bottom = row(v + radius + 1);
    const InverseDepthSums &a = top[u - radius], &b = top[u + radius + 1];
    const InverseDepthSums &c = bottom[u - radius], &d = bottom[u + radius + 1];
    InverseDepthSums sums{d.w - c.w - b.w + a.w, d.uw - c.uw - b.uw + a.uw, d.vw - c.vw - b.vw + a.vw,
                          d.ww - c.ww - b.ww + a.ww};
    sums.uw -= sums.w * static_cast<std::uint64_t>(u);
    sums.vw -= sums.w * static_cast<std::uint64_t>(v);
    return sums;
  }

 private:
  // At most 1 / 1 cm: keeps the sums of a window of 101 x 101 squares within 64 bits.
  static constexpr float kMaxInverseDepth = 100.0f;

  /// Entry u holds the sums of the pixels (x < u, first <= y < v).
  const InverseDepthSums* row(int v) const { return sums_.data() + std::size_t(v % rows_) * stride_; }

  void fill(int v) {
    const InverseDepthSums* above = row(v - 1);
    InverseDepthSums* current = sums_.data() + std::size_t(v % rows_) * stride_;
    const Eigen::Vector3f* points = frame_.points.data() + std::size_t(v - 1) * frame_.width();
    InverseDepthSums line;
    for (int u = 0; u < frame_.width(); ++u) {
      const float z = points[u].z();
      const auto w =
          z > 0 ? static_cast<std::uint64_t>(kInverseDepthScale * std::min(1.0f / z, kMaxInverseDepth) + 0.5) : 0;
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
  int rows_, stride_, next_;
  std::vector<InverseDepthSums> sums_;
};

}  // namespace objectness

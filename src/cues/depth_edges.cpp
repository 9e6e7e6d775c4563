// SPDX-License-Identifier: BSD-3-Clause
#include "cues/depth_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "common/row_bands.hpp"
#include "cues/crease.hpp"
#include "cues/depth_edge_kernel.hpp"

namespace objectness {
namespace {

constexpr uchar kContinues = kBorder << 1;  // working bit: the same surface, or another one, lies across the gap

class DepthEdgeFinder {
 public:
  DepthEdgeFinder(const Frame& frame, const Normals& normals, const DepthNoise& noise, const EdgesConfig& config,
                  cv::Point first)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        config_(config),
        first_(first),
        focal_(frame.camera.focal()),
        kinds_(cv::Mat_<uchar>::zeros(frame.height(), frame.width())) {}

  cv::Mat_<uchar> run(int threads) {
    const cv::Mat_<uchar> places = interestingPlaces(threads);
    forEachSet(places, [&](int pixel, uchar bits) {
      if (bits & kUnlikeLeft) compareWithNext(pixel, -1, pixel % frame_.width());
      if (bits & kUnlikeAbove) compareWithNext(pixel, -frame_.width(), pixel / frame_.width());
    });
    forEachSet(places, [&](int pixel, uchar bits) {
      if (bits & kBesideHole) markBorder(pixel);
    });
    return kinds_;
  }

 private:
  /// Where anything is to be done: bits of markDepthChanges(). A pixel is compared with what is left of it and above:
  /// those before the first pixel tell nothing of those after it.
  cv::Mat_<uchar> interestingPlaces(int threads) const {
    const int width = frame_.width(), height = frame_.height();
    // A little under the step: single precision must not lose one.
    const float min_step_m = static_cast<float>(config_.step_m * (1 - 1e-6));
    cv::Mat_<uchar> places(height, width, uchar(0));
    forRowBands(height - first_.y, threads, [&](int first, int last) {
      const float nan = std::numeric_limits<float>::quiet_NaN();
      std::vector<float> rows[3];
      for (auto& row : rows) row.assign(width + 2, nan);
      const auto load = [&](int v) {
        float* row = rows[(v + 3) % 3].data() + 1;
        for (int u = std::max(0, first_.x - 1); u < width; ++u) {
          row[u] = v < 0 || v >= height ? nan : frame_.points[std::size_t(v) * width + u].z();
        }
      };
      first += first_.y, last += first_.y;
      load(first - 1);
      load(first);
      for (int v = first; v < last; ++v) {
        load(v + 1);
        const float *above = rows[(v + 2) % 3].data() + 1, *row = rows[v % 3].data() + 1;
        const float* below = rows[(v + 1) % 3].data() + 1;
        const int x = first_.x;
        markDepthChanges(above + x, row + x, below + x, width - x, min_step_m, places[v] + x);
      }
    });
    return places;
  }

  /// Calls visit(pixel, bits) for the few pixels that have any.
  template <class Visit>
  void forEachSet(const cv::Mat_<uchar>& places, Visit&& visit) const {
    const int size = static_cast<int>(places.total());
    for (int i = first_.y * places.cols; i < size;) {
      std::uint64_t eight = 1;
      if (i + 8 <= size) std::memcpy(&eight, places.data + i, 8);
      if (eight == 0) {
        i += 8;
        continue;
      }
      if (places.data[i] != 0) visit(i, places.data[i]);
      ++i;
    }
  }

  /// Compares a pixel with the next valid one in a direction, at most `room` steps away.
  void compareWithNext(int pixel, int stride, int room) {
    for (int steps = 1, other = pixel + stride; steps <= room; ++steps, other += stride) {
      if (!valid(other)) continue;
      compare(other, pixel, steps);
      return;
    }
  }

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

  /// For pixels beside missing depth or the outside.
  void markBorder(int pixel) {
    uchar& kinds = kinds_(pixel);
    const bool in_question = !(kinds & (kOccluding | kOccluded | kContinues));
    kinds &= ~kContinues;
    if (in_question) kinds |= kBorder;
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const EdgesConfig& config_;
  const cv::Point first_;
  const double focal_;
  cv::Mat_<uchar> kinds_;
};

}  // namespace

cv::Mat_<uchar> findDepthEdges(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                               const EdgesConfig& config, int threads, cv::Point first) {
  return DepthEdgeFinder(frame, normals, noise, config, first).run(threads);
}

}  // namespace objectness

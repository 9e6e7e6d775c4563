// SPDX-License-Identifier: BSD-3-Clause
#include "segments/geodesic_assignment.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "common/parallel.hpp"

namespace objectness {
namespace {

/// How far a pixel is from a source, and from whose: in the order of the distance, then of the owner.
using Way = std::uint64_t;
constexpr Way kNone = std::numeric_limits<Way>::max();

Way makeWay(float distance, int owner) {
  std::uint32_t bits;
  std::memcpy(&bits, &distance, 4);  // those of numbers from 0 up are in the order of the numbers
  return Way{bits} << 32 | static_cast<std::uint32_t>(owner);
}

float distanceOf(Way way) {
  const std::uint32_t bits = static_cast<std::uint32_t>(way >> 32);
  float distance;
  std::memcpy(&distance, &bits, 4);
  return distance;
}

int ownerOf(Way way) { return static_cast<int>(way & 0xFFFFFFFF); }

/// Pixels to go on from, by distance: shells of it, as a pixel's neighbours mostly lie beyond its own.
class Shells {
 public:
  explicit Shells(double reach_m) : shells_(kCount), per_m_(reach_m > 0 ? kCount / reach_m : 0) {}

  struct Entry {
    Way way;
    int pixel;
  };
  void add(Way way, int pixel) {
    const int shell = static_cast<int>(std::min(distanceOf(way) * per_m_, kCount - 1.0));
    shells_[shell].push_back({way, pixel});
  }
  /// Calls visit(entry) for all, those that it adds as well.
  template <class Visit>
  void drain(Visit&& visit) {
    for (auto& shell : shells_) {
      for (std::size_t k = 0; k < shell.size(); ++k) {
        const Entry entry = shell[k];  // the shell may grow
        visit(entry);
      }
    }
  }

 private:
  static constexpr int kCount = 64;

  std::vector<std::vector<Entry>> shells_;
  double per_m_;
};

/// No way of max_reach_m is longer than this many pixels. From a point to the ray of the next pixel it is at least
/// z / (f |r|), r = (x / z, y / z, 1) of that ray.
int longestWay_px(const Frame& frame, const cv::Mat_<uchar>& open, const cv::Rect& used, double max_reach_m) {
  float nearest = std::numeric_limits<float>::infinity();
  for (int v = used.y; v < used.br().y; ++v) {
    const Eigen::Vector3f* points = frame.points.data() + std::size_t(v) * frame.width();
    for (int u = used.x; u < used.br().x; ++u) {
      if (open(v, u)) nearest = std::min(nearest, points[u].z());  // NaN: stays
    }
  }
  if (!(nearest > 0)) return frame.size();
  const PinholeCamera& camera = frame.camera;
  double longest_ray = 1;
  for (const double u : {0.0, camera.width - 1.0}) {
    for (const double v : {0.0, camera.height - 1.0}) longest_ray = std::max(longest_ray, camera.ray(u, v).norm());
  }
  const double pixels = max_reach_m * std::max(camera.fx, camera.fy) * longest_ray / nearest;
  return static_cast<int>(std::min(pixels, 1e6)) + 2;
}

/// The ways of the pixels in rows top..bottom-1, by index from the first of them. Open pixels are in columns
/// left..right-1.
std::vector<Way> shortestWays(const Frame& frame, const cv::Mat_<uchar>& open, const GeodesicLimits& limits,
                              const cv::Mat_<int>& owner, int top, int bottom, int left, int right) {
  const int width = frame.width(), height = bottom - top;
  const Eigen::Vector3f* points = frame.points.data() + std::size_t(top) * width;
  const uchar* opens = open[top];
  const int* owners = owner[top];
  std::vector<Way> ways(std::size_t(height) * width, kNone);
  Shells shells(limits.max_reach_m);
  const auto go = [&](int from, int to, float so_far, int whose) {
    const float step = (points[to] - points[from]).norm();
    const float reach = so_far + step;
    if (!(step <= limits.max_step_m) || reach > limits.max_reach_m) return;
    const Way way = makeWay(reach, whose);
    if (way >= ways[to]) return;
    ways[to] = way;
    shells.add(way, to);
  };
  const auto forNeighbours = [&](int u, int v, auto&& visit) {
    for (int y = std::max(0, v - 1); y <= std::min(height - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
        if (x != u || y != v) visit(y * width + x);
      }
    }
  };

  for (int v = 0; v < height; ++v) {
    for (int u = left; u < right; ++u) {
      const int pixel = v * width + u;
      if (owners[pixel] >= 0 || !opens[pixel]) continue;
      forNeighbours(u, v, [&](int source) {
        if (owners[source] >= 0) go(source, pixel, 0, owners[source]);
      });
    }
  }
  // Whatever the order, each pixel ends with its shortest way; by shells, few ways are gone that are not.
  shells.drain([&](const Shells::Entry& entry) {
    if (entry.way != ways[entry.pixel]) return;  // a shorter one was found
    forNeighbours(entry.pixel % width, entry.pixel / width, [&](int next) {
      if (owners[next] < 0 && opens[next]) go(entry.pixel, next, distanceOf(entry.way), ownerOf(entry.way));
    });
  });
  return ways;
}

}  // namespace

void assignGeodesic(const Frame& frame, const cv::Mat_<uchar>& open, const GeodesicLimits& limits, cv::Mat_<int>& owner,
                    int threads) {
  const cv::Rect used = cv::boundingRect(open);
  if (used.empty()) return;
  const int width = frame.width(), height = used.height;
  // A band sees as far beyond its rows as any way can lead.
  const int margin = threads == 1 ? height : longestWay_px(frame, open, used, limits.max_reach_m);
  const int bands = std::clamp(height / (2 * margin), 1, ThreadPool::resolve(threads));
  std::vector<std::vector<Way>> ways(bands);
  const auto firstRow = [&](int band) { return used.y + height * band / bands; };
  // Sources need not be open: they may lie beside what is.
  const int top = std::max(0, used.y - 1), bottom = std::min(frame.height(), used.br().y + 1);
  const auto topRow = [&](int band) { return band == 0 ? top : std::max(top, firstRow(band) - margin); };
  parallelFor(bands, threads, [&](int band) {
    const int end = band + 1 == bands ? bottom : std::min(bottom, firstRow(band + 1) + margin);
    ways[band] = shortestWays(frame, open, limits, owner, topRow(band), end, used.x, used.br().x);
  });
  parallelFor(bands, threads, [&](int band) {
    const Way* way = ways[band].data() - std::ptrdiff_t(topRow(band)) * width;
    for (int v = firstRow(band); v < firstRow(band + 1); ++v) {
      for (int i = v * width + used.x; i < v * width + used.br().x; ++i) {
        if (way[i] != kNone) owner[0][i] = ownerOf(way[i]);
      }
    }
  });
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "scene/wall_patches.hpp"

#include <algorithm>
#include <cmath>

#include "common/row_bands.hpp"
#include "scene/connected_components_2d.hpp"
#include "scene/plane_grid.hpp"

namespace objectness {
namespace {

constexpr double kMinAreaM2 = 0.004;
constexpr double kMaxInsideShare = 0.5;
constexpr double kBorderFactor = 0.5;   // border pixels per square root of the patch's pixels
constexpr double kCeilingShare = 0.05;  // of the patch, over the ceiling
constexpr float kMinToleranceM = 0.008f;
constexpr float kToleranceSigmas = 4.0f;
constexpr float kMinNormalCosine = 0.866f;  // 30 deg

struct Patch {
  int pixels = 0, border = 0, too_high = 0;
  double area_m2 = 0;

  bool mayBeWall() const {
    return area_m2 > kMinAreaM2 && (border > kBorderFactor * std::sqrt(pixels) || too_high > kCeilingShare * pixels);
  }
};

/// Bit k of a pixel of the mask: it lies on the k-th of the table's other planes, and faces as it does.
cv::Mat_<uchar> planesOf(const Frame& frame, const Normals& normals, const Table& table, const cv::Mat_<uchar>& mask,
                         int threads) {
  std::vector<FastPlane> planes(table.other_planes.begin(), table.other_planes.end());
  cv::Mat_<uchar> result(mask.size());
  const auto bitsOf = [&](int i) {
    const Eigen::Vector3f& p = frame.points[i];
    const float tolerance = std::max(kMinToleranceM, kToleranceSigmas * static_cast<float>(table.noise.sigma(p.z())));
    int bits = 0;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (std::abs(planes[k].height(p)) > tolerance) continue;
      if (normals.radius_px[i] > 0 && normals.normal[i].dot(planes[k].normal) < kMinNormalCosine) continue;
      bits |= 1 << k;
    }
    return static_cast<uchar>(bits);
  };
  forRowBands(mask.rows, threads, [&](int first, int last) {
    for (int i = first * mask.cols; i < last * mask.cols; ++i) result.data[i] = mask.data[i] ? bitsOf(i) : uchar(0);
  });
  return result;
}

std::vector<Patch> measure(const MaskComponents& parts, const Frame& frame, const HeightMap& map, double max_height_m) {
  const double focal = frame.camera.focal();
  std::vector<Patch> patches(parts.count);
  for (const Run& run : parts.runs) {
    Patch& patch = patches[run.part];
    const bool edge_row = run.row == 0 || run.row + 1 == frame.height();
    const int pixels = run.last - run.first;
    patch.pixels += pixels;
    patch.border += edge_row ? pixels : std::min(pixels, (run.first == 0) + (run.last == frame.width()));
    for (int u = run.first; u < run.last; ++u) {
      const double z = frame.points[run.row * frame.width() + u].z();
      patch.too_high += map.height_m(run.row, u) > max_height_m;
      patch.area_m2 += z * z / (focal * focal);
    }
  }
  return patches;
}

/// Of the patches that may be walls: how many of their pixels lie over the table.
std::vector<int> countInside(const MaskComponents& parts, const std::vector<Patch>& patches, const Frame& frame,
                             const Table& table) {
  const Eigen::Matrix<double, 2, 3> axes = table.T_table_camera.linear().topRows<2>();
  std::vector<int> inside(parts.count, 0);
  for (const Run& run : parts.runs) {
    if (!patches[run.part].mayBeWall()) continue;
    for (int u = run.first; u < run.last; ++u) {
      const Eigen::Vector2d foot = axes * frame.points[run.row * frame.width() + u].cast<double>();
      inside[run.part] += table.extent.at(foot.x(), foot.y()) == TableExtent::kCore;
    }
  }
  return inside;
}

/// What of the mask lies on a plane.
struct PlanePatches {
  MaskComponents parts;
  std::vector<Patch> patches;  ///< by part
  std::vector<int> inside;
};

}  // namespace

void removeWalls(const Frame& frame, const Normals& normals, const Table& table, const HeightMap& map,
                 const ObjectPointsConfig& config, cv::Mat_<uchar>& mask, int threads) {
  CV_Assert(table.other_planes.size() <= 8);  // findTable() looks at no more
  const cv::Mat_<uchar> planes = planesOf(frame, normals, table, mask, threads);
  const auto findWalls = [&](int k) {
    PlanePatches found{findComponents(planes & mask & uchar(1 << k), Neighbours::kEight), {}, {}};
    found.patches = measure(found.parts, frame, map, config.max_height_m);
    found.inside = countInside(found.parts, found.patches, frame, table);
    return found;
  };
  const int count = static_cast<int>(table.other_planes.size());
  std::vector<PlanePatches> of_plane(count);
  parallelFor(count, threads, [&](int k) { of_plane[k] = findWalls(k); });
  bool changed = false;  // pixels cleared for one plane must not count for the next
  for (int k = 0; k < count; ++k) {
    const PlanePatches found = changed ? findWalls(k) : std::move(of_plane[k]);
    for (const Run& run : found.parts.runs) {
      const Patch& patch = found.patches[run.part];
      if (!patch.mayBeWall() || !(found.inside[run.part] < kMaxInsideShare * patch.pixels)) continue;
      std::fill(mask[run.row] + run.first, mask[run.row] + run.last, uchar(0));
      changed = true;
    }
  }
}

}  // namespace objectness

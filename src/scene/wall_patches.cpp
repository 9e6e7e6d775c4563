// SPDX-License-Identifier: BSD-3-Clause
#include "wall_patches.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "plane_grid.hpp"

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
  int pixels = 0, inside = 0, border = 0, too_high = 0;
  double area_m2 = 0;
};

cv::Mat_<uchar> onPlane(const Frame& frame, const Normals& normals, const Table& table, const Plane& plane,
                        const cv::Mat_<uchar>& mask) {
  const FastPlane fast(plane);
  cv::Mat_<uchar> result(mask.size(), uchar(0));
  for (int i = 0; i < frame.size(); ++i) {
    if (mask.data[i] == 0) continue;
    const Eigen::Vector3f& p = frame.points[i];
    const float tolerance = std::max(kMinToleranceM, kToleranceSigmas * static_cast<float>(table.noise.sigma(p.z())));
    if (std::abs(fast.height(p)) > tolerance) continue;
    if (normals.radius_px[i] > 0 && normals.normal[i].dot(fast.normal) < kMinNormalCosine) continue;
    result.data[i] = 255;
  }
  return result;
}

}  // namespace

void removeWalls(const Frame& frame, const Normals& normals, const Table& table, const HeightMap& map,
                 const ObjectPointsConfig& config, cv::Mat_<uchar>& mask) {
  const int width = frame.width(), height = frame.height();
  const double focal = frame.camera.focal();
  const Eigen::Matrix<double, 2, 3> axes = table.T_table_camera.linear().topRows<2>();

  for (const Plane& plane : table.other_planes) {
    const cv::Mat_<uchar> candidates = onPlane(frame, normals, table, plane, mask);
    cv::Mat_<int> labels;
    std::vector<Patch> patches(cv::connectedComponents(candidates, labels, 8, CV_32S));
    for (int v = 0, i = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u, ++i) {
        if (candidates.data[i] == 0) continue;
        Patch& patch = patches[labels(v, u)];
        const Eigen::Vector3d p = frame.points[i].cast<double>();
        const Eigen::Vector2d foot = axes * p;
        ++patch.pixels;
        patch.inside += table.extent.at(foot.x(), foot.y()) == kCore;
        patch.border += u == 0 || v == 0 || u + 1 == width || v + 1 == height;
        patch.too_high += map.height_m(v, u) > config.max_height_m;
        patch.area_m2 += p.z() * p.z() / (focal * focal);
      }
    }
    std::vector<bool> wall(patches.size(), false);
    for (std::size_t k = 1; k < patches.size(); ++k) {
      const Patch& patch = patches[k];
      wall[k] =
          patch.area_m2 > kMinAreaM2 && patch.inside < kMaxInsideShare * patch.pixels &&
          (patch.border > kBorderFactor * std::sqrt(patch.pixels) || patch.too_high > kCeilingShare * patch.pixels);
    }
    for (int i = 0; i < frame.size(); ++i) {
      if (candidates.data[i] && wall[labels(i / width, i % width)]) mask.data[i] = 0;
    }
  }
}

}  // namespace objectness

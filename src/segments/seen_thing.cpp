// SPDX-License-Identifier: BSD-3-Clause
#include "segments/seen_thing.hpp"

#include <algorithm>
#include <cmath>

#include "common/share_below.hpp"

namespace objectness {
namespace {

constexpr std::size_t kPoints = 500;
constexpr float kGrazing = 0.259f;     // cosine to the line of sight, 75 deg
constexpr float kLevel = 0.7f;         // a level face may be seen at any angle
constexpr float kLevelTop = 0.94f;     // 20 deg
constexpr double kTopShare = 0.98;     // of points that are not over a top that is not level
constexpr float kTopDepthM = 0.02f;    // how far below the highest points a level top is looked for
constexpr double kMinTopShare = 0.08;  // of all points
constexpr std::size_t kMinTopPoints = 8;
constexpr double kLayerShare = 0.95;  // of a level top's points that are not over it
constexpr double kMinLayerM = 0.004, kLayerSigmas = 6;
constexpr double kMaxTopErrorM = 0.015;
constexpr double kMinHeightM = 0.005;

void findTop(SeenThing& thing) {
  std::vector<float> heights, level;
  for (const SeenPoint& q : thing.points) heights.push_back(q.place.z());
  thing.top_m = std::max<double>(shareBelow(kTopShare, heights), thing.base_m + kMinHeightM);
  for (const SeenPoint& q : thing.points) {
    if (q.has_normal && q.normal.z() > kLevelTop && q.place.z() > thing.top_m - kTopDepthM)
      level.push_back(q.place.z());
  }
  if (level.size() < kMinTopPoints || level.size() < kMinTopShare * thing.points.size()) return;
  const double layer_m = std::max(kMinLayerM, kLayerSigmas * thing.sigma_m);
  const double lowest = shareBelow(kLayerShare, level) - layer_m;
  level.erase(std::remove_if(level.begin(), level.end(), [&](float z) { return z <= lowest; }), level.end());
  const double top_m = shareBelow(0.5, level);
  if (thing.top_m - top_m > kMaxTopErrorM || top_m < thing.base_m + kMinHeightM) return;
  thing.top_m = top_m;
  thing.level_top = true;
}

}  // namespace

SeenThing seeThing(const Frame& frame, const Normals& normals, const Table& table, const std::vector<int>& pixels,
                   double base_m) {
  SeenThing thing;
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  thing.eye = T_table_camera.translation();
  thing.base_m = base_m;
  const std::size_t step = 1 + pixels.size() / kPoints;
  double depths = 0;
  for (std::size_t i = 0; i < pixels.size(); i += step) {
    const Eigen::Vector3f& p = frame.points[pixels[i]];
    if (!(p.z() > 0)) continue;
    SeenPoint q;
    q.place = T_table_camera * p;
    q.normal.setZero();
    q.has_normal = normals.radius_px[pixels[i]] > 0;
    if (q.has_normal) {
      q.normal = T_table_camera.linear() * normals.normal[pixels[i]];
      q.upright = q.normal.head<2>().norm();
      const float cosine = std::abs(q.normal.dot((thing.eye - q.place).normalized()));
      if (cosine < kGrazing && std::abs(q.normal.z()) < kLevel) continue;
    }
    depths += p.z();
    thing.points.push_back(q);
  }
  if (thing.points.empty()) return thing;
  thing.sigma_m = table.noise.sigma(depths / static_cast<double>(thing.points.size()));
  findTop(thing);
  return thing;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#include "segments/seen_space.hpp"

#include <cmath>

namespace objectness {
namespace {

constexpr double kToleranceM = 0.012;  // of depth; edges are blurred
constexpr double kNearestM = 0.05;

}  // namespace

Seen SeenSpace::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d q = T_camera_table_ * place;
  if (q.z() < kNearestM) return Seen::kUnknown;
  const Eigen::Vector2d pixel = frame_.camera.project(q);
  if (!(pixel.x() > -0.5 && pixel.y() > -0.5 && pixel.x() < frame_.width() - 0.5 &&
        pixel.y() < frame_.height() - 0.5)) {
    return Seen::kUnknown;
  }
  const int u = static_cast<int>(pixel.x() + 0.5), v = static_cast<int>(pixel.y() + 0.5);
  const double depth = frame_.points[v * frame_.width() + u].z();
  if (!(depth > 0)) return Seen::kUnknown;
  if (depth > q.z() + kToleranceM) return Seen::kFree;
  if (labels_(v, u) == own_) return Seen::kOwn;
  return depth < q.z() - kToleranceM ? Seen::kBehindOther : Seen::kOther;
}

}  // namespace objectness

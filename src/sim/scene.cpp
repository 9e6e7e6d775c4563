// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene.hpp"

#include <cmath>

#include "common/angles.hpp"

namespace objectness::sim {

Eigen::Isometry3d lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() = eye;
  return pose;
}

Eigen::Isometry3d orbitPose(const Scene& scene, int frame, int count) {
  const double angle = kOrbitSwing_deg * kPi / 180 * std::sin(2 * kPi * frame / count);
  const Eigen::Isometry3d turn = Eigen::Translation3d(scene.target) *
                                 Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
                                 Eigen::Translation3d(-scene.target);
  return turn * scene.T_world_camera;
}

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot_arm.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kColumnRadius_m = 0.07, kUpperRadius_m = 0.05, kForeRadius_m = 0.04;
constexpr double kFinger_m = 0.06, kPalm_m = 0.05, kFlange_m = 0.1, kOpening_m = 0.07;

/// A rod with round ends from one point to another, in a frame along it so that its bound is tight.
Part rod(const Vector3d& from, const Vector3d& to, double radius) {
  Eigen::Isometry3d T_thing_part(Eigen::Translation3d(from) *
                                 Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from));
  return {Tube{{Vector3d::Zero(), Vector3d(0, 0, (to - from).norm())}, radius}, T_thing_part};
}

}  // namespace

Placed placeArm(const ArmPose& pose) {
  const Vector3d palm = pose.hand + Vector3d(0, 0, kFinger_m), flange = palm + Vector3d(0, 0, kPalm_m);
  const Vector3d wrist = flange + Vector3d(0, 0, kFlange_m);
  const Vector3d elbow = (pose.shoulder + wrist) / 2 + Vector3d(0, 0, pose.elbow_m);
  const Eigen::Isometry3d T_world_palm =
      Eigen::Translation3d(palm) * Eigen::AngleAxisd(pose.hand_turn, Vector3d::UnitZ());
  Thing arm{"arm", {}, false, {0, 0}};
  arm.parts.push_back(
      rod(pose.shoulder - Vector3d(0, 0, pose.column_m - kColumnRadius_m), pose.shoulder, kColumnRadius_m));
  arm.parts.push_back(rod(pose.shoulder, elbow, kUpperRadius_m));
  arm.parts.push_back(rod(elbow, wrist, kForeRadius_m));
  arm.parts.push_back(rod(wrist, flange, 0.8 * kForeRadius_m));
  arm.parts.emplace_back(Box{{kOpening_m + 0.04, 0.04, kPalm_m}}, T_world_palm);
  for (const int side : {-1, 1}) {
    arm.parts.emplace_back(Box{{0.012, 0.022, kFinger_m}},
                           T_world_palm * Eigen::Translation3d(side * kOpening_m / 2, 0, -kFinger_m));
  }
  return place(arm, Eigen::Isometry3d::Identity());
}

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#include "segments/hole_box.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr double kMaxHalfAngle = 0.6;    // of the outline, seen from the camera's foot; radians
constexpr double kMinHeightShare = 0.6;  // of the width: lower boxes may be flat things, or balls

}  // namespace

std::optional<OrientedBox> boxOfHole(const Table& table, const std::vector<Eigen::Vector2d>& outline) {
  if (outline.size() < 3) return std::nullopt;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : outline) middle += p / static_cast<double>(outline.size());
  if (!(middle.norm() > 0)) return std::nullopt;
  Eigen::Vector2d away = middle.normalized();
  double left = 0, right = 0;
  for (const Eigen::Vector2d& p : outline) {
    const double angle = std::atan2(away.x() * p.y() - away.y() * p.x(), away.dot(p));
    left = std::max(left, angle), right = std::min(right, angle);
  }
  const double half = 0.5 * (left - right);
  if (!(half < kMaxHalfAngle)) return std::nullopt;
  away = Eigen::Rotation2Dd(0.5 * (left + right)) * away;
  double front = away.dot(outline[0]), back = front;
  for (const Eigen::Vector2d& p : outline) front = std::min(front, p.norm()), back = std::max(back, p.norm());

  // Two tangents from the camera's foot and the nearest point: front = centre - radius, radius = centre sin(half).
  const double centre = front / (1 - std::sin(half)), radius = centre * std::sin(half);
  const double height = table.d * (1 - (centre + radius) / back);
  if (!(height > kMinHeightShare * 2 * radius) || !(height < table.d)) return std::nullopt;
  Eigen::Isometry3d T_table_box = Eigen::Isometry3d::Identity();
  T_table_box.translation() << centre * away, 0.5 * height;
  T_table_box.linear().col(0) << away, 0;
  T_table_box.linear().col(1) << -away.y(), away.x(), 0;
  return OrientedBox{table.T_table_camera.inverse() * T_table_box, {2 * radius, 2 * radius, height}};
}

}  // namespace objectness

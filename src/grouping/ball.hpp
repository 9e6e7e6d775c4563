// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace objectness {

/// Bounding sphere, for lower bounds of distances.
struct Ball {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float radius = 0;

  static constexpr float kRounding_m = 1e-4f;

  /// No point of one ball is nearer to one of the other than this.
  float distance(const Ball& other) const {
    return (centre - other.centre).norm() - radius - other.radius - kRounding_m;
  }
};

inline Ball ballAround(const std::vector<Eigen::Vector3f>& points) {
  Ball ball;
  for (const Eigen::Vector3f& p : points) ball.centre += p / static_cast<float>(points.size());
  for (const Eigen::Vector3f& p : points) ball.radius = std::max(ball.radius, (p - ball.centre).norm());
  return ball;
}

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace objectness::sim {

/// A box or a cylinder about a thing, metres.
struct ConvexBound {
  Eigen::Isometry3d T_world_centre = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< of the cylinder: radius, radius, half its height
  bool round = false;

  /// Of the box, or of the box about the cylinder; world frame.
  std::array<Eigen::Vector3d, 8> corners() const;
  /// Half its extent along a unit vector of the world frame.
  double reach(const Eigen::Vector3d& direction) const;
};

/// A lower bound of the distance between two bounds, negative where none was shown: the widest gap between their
/// projections on the axes that separate boxes from boxes and, of those that separate cylinders, the ones that count
/// while they stand upright. Exact for two upright cylinders, and for a box whose face, edge or side corner is nearest.
double separation(const ConvexBound& a, const ConvexBound& b);

}  // namespace objectness::sim

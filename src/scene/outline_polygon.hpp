// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace objectness {

/// A place on a closed outline.
struct OutlinePoint {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< metres
  bool measured = false;                            ///< otherwise only about right
};

struct OutlinePolygon {
  std::vector<Eigen::Vector2d> corners;
  std::vector<char> measured;  ///< by corner: the side from it to the next one follows measured points
};

/// A polygon of few corners through the points, in their order. Sides of measured points are the lines that fit them
/// best, so corners are sharp and the noise of single points is averaged. A few points that are measured among others
/// that are not, or the other way round, are left out.
OutlinePolygon polygonThrough(const std::vector<OutlinePoint>& points);

}  // namespace objectness

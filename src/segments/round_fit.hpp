// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "segments/seen_thing.hpp"

namespace objectness {

/// A surface of revolution about an upright axis: can, bowl, bottle, ball, the body of a mug.
struct RoundFit {
  Eigen::Vector2d axis = Eigen::Vector2d::Zero();  ///< its place in the plan, table frame, metres
  double radius_m = 0;                             ///< the largest
  double widest_m = 0;                             ///< height over the table of the largest radius
  double turn_deg = 0;   ///< 70 % of the normals point less far past the axis, seen from above
  double spread_m = 0;   ///< 70 % of neighbours in height differ less in radius, across the surface
  double beyond = 0;     ///< share of the points that are clearly farther from the axis
  double one_sided = 0;  ///< 1: all of these lie in one direction; 0: all around
  Eigen::Vector2d to_beyond = Eigen::Vector2d::Zero();  ///< from the axis to the mean of these
  double reach_m = 0;                                   ///< from the axis to the end of these
};

/// The axis that explains walls best: normals meet at it (linear, reweighted), then points of equal height and side of
/// the wall have one radius (a pattern search). The hidden half follows from it. The radius is that of bands of equal
/// height; of a wall that widens downwards it is continued to the foot, as the blurred rim of the foot tells nothing.
/// None with too little of a wall.
std::optional<RoundFit> fitRound(const SeenThing& thing);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "sim/random.hpp"
#include "sim/shapes.hpp"

namespace objectness::sim {

/// A household thing of 4 to 30 cm in a frame of its own: z up, standing on z = 0.
struct Thing {
  std::string kind;
  std::vector<Shape> parts;  ///< the largest first
  /// The first part's bounding box or cylinder fits so well that what is put beside it touches the thing itself.
  bool tight_sides = false;
  /// Half the width and depth of the flat top that can carry something; 0 when there is none.
  Eigen::Vector2d top_half = Eigen::Vector2d::Zero();

  Eigen::AlignedBox3d box() const;  ///< about all parts
  double height() const { return box().max().z(); }
};

/// A thing of random size: a box, cylinder, cone, sphere, bowl, mug or bottle.
Thing makeThing(const std::string& kind, Random& random);

/// A board or book that can lean, thin in y and long in z.
Thing makeSlab(Random& random);

/// BGR: not dark, not grey.
cv::Vec3b drawColor(Random& random);

}  // namespace objectness::sim

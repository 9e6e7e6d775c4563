// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/placement.hpp"

namespace objectness::sim {

/// An arm on a column: upper arm, forearm, and a hand with two fingers that points down. Metres, world frame.
struct ArmPose {
  Eigen::Vector3d shoulder, hand;  ///< the top of the column; where the fingers end
  double column_m = 0;             ///< height of the column under the shoulder
  double elbow_m = 0;              ///< of the elbow over the middle between shoulder and wrist
  double hand_turn = 0;            ///< about the vertical, radians
};

Placed placeArm(const ArmPose& pose);

}  // namespace objectness::sim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "objectness_segmentation/tracking/tracker.hpp"

namespace objectness {

/// The boxes of objects that do not move, settled over the last frames: centre, turn and sides are the medians of those
/// of these frames, which one odd frame does not move. Their axes keep their names, also where sides are nearly equal.
/// An object that moved, by the centre of what is seen of it, starts again.
class SteadyBoxes {
 public:
  /// identities: of the segments, in their order. frames: how many the medians are over; 1: boxes stay as they are.
  /// Changes Segment::box and Segment::round.
  void settle(const Frame& frame, const std::vector<Identity>& identities, const Eigen::Isometry3d& T_fixed_camera,
              int frames, std::vector<Segment>& segments);

  void clear() { objects_.clear(); }

 private:
  struct Look {
    OrientedBox box;  ///< fixed frame, axes named as those of the first look
    bool round = false;
  };
  struct Object {
    std::deque<Look> looks;
    Eigen::Vector3d seen_centre;  ///< of the first look
    int missed = 0;
    bool round = false;
  };
  std::map<std::uint64_t, Object> objects_;  ///< by Identity::id
};

}  // namespace objectness

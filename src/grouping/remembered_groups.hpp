// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "grouping/group_selection.hpp"

namespace objectness {

/// What was found in the frame before, where nothing has changed since: labels as in Segmentation::labels, kUnknown
/// where something has.
struct GroupingMemory {
  static constexpr ushort kUnknown = 65535;
  cv::Mat_<ushort> labels;
};

/// The objects of the frame before in the pieces of this one. What was one object is evidence that it still is;
/// without it, borderline links would flicker from frame to frame.
class RememberedGroups {
 public:
  /// memory: of the size of the pieces' picture or a whole multiple of it.
  RememberedGroups(const Pieces& pieces, const GroupingMemory& memory);

  /// The pieces that were mostly of one object, by object: ascending, none empty.
  std::vector<std::vector<int>> groups() const;

  /// Adds to the log odds of links between pieces that were of one object, takes from those of different ones.
  void weighLinks(double log_odds, std::vector<Link>& links) const;

  /// Sets GroupHypothesis::remembered: 1 for a group that is what was one object, falling to 0 for one that shares half
  /// its points with it (intersection over union); -1 for one that was no object at all, rising to 0 where half was.
  void compare(std::vector<GroupHypothesis>& groups) const;

 private:
  std::vector<int> label_;  ///< by piece: that of most of its known pixels; 0: of no object, or not known
  std::vector<std::vector<std::pair<int, int>>> pixels_;  ///< by piece: pixels by label
  std::vector<int> known_;                                ///< by piece: known pixels
  std::vector<int> sizes_;                                ///< by label: known pixels in pieces
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "search/box_ranges.hpp"
#include "search/column_table.hpp"
#include "search/search.hpp"

namespace objectness {

/// What no box of a node can exceed (BoundedSearch). Follows the search down, node by node: superpixels that lie
/// outside all boxes of a node or inside all of them are settled for everything below it.
class NodeBound {
 public:
  NodeBound(const CueVolumes& volumes, const SearchTask& task, const std::vector<float>& top_visible);

  /// Boxes below this are not looked for any more. Only upwards.
  void raiseThreshold(double threshold);

  /// The least range with all heights of the node at which a box may reach the threshold. depth: of the node, 0 = all
  /// boxes. Call in depth-first order: the parent was the last node bounded at depth - 1.
  HeightRange possible(const BoxRanges& node, int depth);

 private:
  /// The superpixels as they stand below a node.
  struct Level {
    std::vector<int> cut;                ///< those that some boxes may cut
    std::vector<float> counts, squares;  ///< per height: sum of k and of k^2 / n over those inside all boxes
    int sums = 0;                        ///< the level, this one or one above, whose counts and squares are meant
  };
  CornerColumns nothing() const { return {nothing_.data(), nothing_.data(), nothing_.data(), nothing_.data()}; }
  HeightRange needed(const BoxRanges& node);
  void settleSuperpixels(const BoxRanges& node, int depth);
  void addWhole(int superpixel, int depth);

  const SearchTask& task_;
  const int nx_, ny_;
  const Eigen::Vector3d viewpoint_;
  const ColumnTable edges_, filled_;
  const std::vector<SuperpixelTable> superpixels_;
  BoundConstants constants_;
  double constant_slack_;
  float margin_slack_;
  std::vector<std::uint16_t> nothing_;  ///< a column without a voxel
  std::vector<Level> levels_;           ///< levels_[d]: above the nodes of depth d
  std::vector<CutSuperpixel> cut_;      ///< of the current node
  std::vector<float> needed_;
};

}  // namespace objectness

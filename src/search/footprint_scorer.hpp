// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "search/column_table.hpp"
#include "search/score_kernel.hpp"
#include "search/search.hpp"

namespace objectness {

/// Scores the boxes over one footprint at all heights at once: the same values as scoreBox().
class FootprintScorer {
 public:
  FootprintScorer(const CueVolumes& volumes, int angle, const SearchTask& task, const std::vector<float>& top_visible);

  /// Appends the boxes of the sampling with heights in `heights` whose objectness reaches the threshold. Returns how
  /// many boxes were scored.
  int score(int x0, int x1, int y0, int y1, HeightRange heights, double threshold, std::vector<ScoredBox>& boxes);

 private:
  bool passesGates(int height) const;

  const CueVolumes& volumes_;
  const SearchTask& task_;
  const int angle_;
  ScoreConstants constants_;
  const ColumnTable edges_, filled_, occupied_;
  const std::vector<SuperpixelTable> tables_;
  std::vector<SuperpixelColumns> superpixels_;
  std::vector<int> integers_;
  std::vector<float> floats_;
  std::vector<double> sums_;
  ScoreColumns columns_;
};

}  // namespace objectness

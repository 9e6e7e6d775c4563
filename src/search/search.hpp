// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "integral/cue_volumes.hpp"
#include "objectness/objectness.hpp"
#include "search/box_sampler.hpp"
#include "search/running_threshold.hpp"

namespace objectness {

/// What a search needs to know besides the volumes.
struct SearchTask {
  Sampling sampling;
  Ring ring;
  ObjectnessConfig objectness;
  double threshold = 0;  ///< boxes of at least this objectness are kept
  /// For searchBounded(): boxes below what it has risen to are left out, too; every box that is kept is added to it.
  RunningThreshold* running = nullptr;
};

/// The boxes of one angle whose objectness is at least the threshold.
struct SearchResult {
  std::vector<ScoredBox> boxes;  ///< best first (better())
  std::int64_t sampled = 0;      ///< boxes of the sampling
  std::int64_t scored = 0;       ///< of them scored in full; the rest could not reach the threshold
  std::int64_t nodes = 0;        ///< sets of boxes that a bound was computed for
  std::string unbounded;  ///< why searchBounded() could not use its bounds and scanned instead; empty if it could
};

/// All boxes of the sampling of paper Sec. 2.2 whose scoreBox() reaches the threshold, to the last bit those of a plain
/// loop over all boxes (test/reference/plain_search.hpp): bounds all heights of a footprint at once without the
/// superpixel cue (which is at most 1), and scores only the boxes whose bound reaches the threshold.
SearchResult searchScan(const CueVolumes& volumes, int angle, const SearchTask& task);

/// The same result, to the last bit: branch and bound over intervals of the four faces, all heights at once. For
/// weight_edges and weight_outer >= 0 and weight_free <= 0; with other weights it scans, and says so.
SearchResult searchBounded(const CueVolumes& volumes, int angle, const SearchTask& task);

/// Puts boxes in the order of better().
void sortBestFirst(std::vector<ScoredBox>& boxes);

/// The boxes of lists that are each in the order of better() in one list in that order, on up to `threads` threads (0:
/// one per processor).
std::vector<ScoredBox> mergeBestFirst(const std::vector<std::vector<ScoredBox>>& lists, int threads);

}  // namespace objectness

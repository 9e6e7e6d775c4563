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

}  // namespace objectness

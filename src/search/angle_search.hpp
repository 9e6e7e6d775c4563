// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "integral/cue_points.hpp"
#include "objectness/objectness.hpp"
#include "objectness_segmentation/integral/volume_config.hpp"
#include "search/box_sampler.hpp"

namespace objectness {

/// The boxes of all angles that reached the threshold.
struct SearchOutcome {
  Status status;                 ///< kVolumeTooLarge, kCancelled
  std::vector<Grid> grids;       ///< one per angle
  std::vector<ScoredBox> boxes;  ///< best first (better()): all that reach the threshold, or the search.top_k best
  std::int64_t sampled = 0;      ///< boxes of the sampling (Sec. 2.2)
  std::int64_t scored = 0;       ///< of them scored in full; the others provably do not reach the threshold
  std::int64_t passed = 0;       ///< of them at or above the threshold
  std::int64_t nodes = 0;        ///< sets of boxes that were bounded together
  double threshold = 0;          ///< what all boxes reach: the one given, or the objectness of the last of top_k
  std::string unbounded;         ///< why the bounds could not be used (SearchResult::unbounded)
};

/// The configuration of the search, gathered from the stages it belongs to.
struct SearchSettings {
  VolumeConfig volume;
  SearchConfig search;
  ObjectnessConfig objectness;
  double threshold = 0;
  int threads = 2;
};

/// Builds the integral volumes of every angle (Sec. 2.1) and scores every box in them. The result does not depend on
/// the number of threads, nor, with top_k, on where it starts (top_k_start). `cancel` may be null.
SearchOutcome searchAllAngles(const Frame& frame, const Table& table, const CuePoints& points,
                              const SearchSettings& settings, const std::atomic<bool>* cancel);

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "frame_methods.hpp"
#include "integral/voxelizer.hpp"
#include "search/angle_search.hpp"
#include "search/search.hpp"

namespace objectness::benchmarks {

using Search = SearchResult (*)(const CueVolumes&, int angle, const SearchTask&);

/// Seconds of CPU time of one thread.
struct SearchTimes {
  double volumes = 0, search = 0;
};

/// What a search of one scene starts from: all that comes before it in the pipeline is done.
class SearchInput {
 public:
  /// Throws std::runtime_error when there is no table or the volume is too large.
  SearchInput(const Frame& frame, const Config& config);

  /// Volumes and search of one angle after the other, as in the pipeline; without a search only the volumes. What the
  /// angles found is put together in `result`, in their order.
  SearchTimes run(Search search, SearchResult& result) const;

  /// Volumes and search by the threads of the configuration.
  SearchOutcome searchAll() const { return searchAllAngles(frame_, scene_.table, points_, settings_, nullptr); }

 private:
  const Frame& frame_;
  Segmentation scene_;
  CuePoints points_;
  SearchSettings settings_;
  SearchTask task_;
  std::vector<Grid> grids_;
};

}  // namespace objectness::benchmarks

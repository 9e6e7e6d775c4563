// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/search.hpp"

namespace objectness {

/// All boxes of the sampling of paper Sec. 2.2 whose scoreBox() reaches the threshold, to the last bit those of a plain
/// loop over all boxes (test/reference/plain_search.hpp): bounds all heights of a footprint at once without the
/// superpixel cue (which is at most 1), and scores only the boxes whose bound reaches the threshold.
SearchResult searchScan(const CueVolumes& volumes, int angle, const SearchTask& task);

}  // namespace objectness

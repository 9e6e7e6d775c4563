// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/search.hpp"

namespace objectness {

/// What searchScan() finds, to the last bit: branch and bound over intervals of the four faces, all heights at once.
/// For weight_edges and weight_outer >= 0 and weight_free <= 0; with other weights it scans, and says so.
SearchResult searchBounded(const CueVolumes& volumes, int angle, const SearchTask& task);

}  // namespace objectness

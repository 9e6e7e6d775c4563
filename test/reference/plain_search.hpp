// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/search.hpp"

namespace objectness {

/// Scores every box by scoreBox(): a plain nested loop over the sampling of paper Sec. 2.2. The definition of the
/// result of searchScan() and searchBounded().
SearchResult searchPlain(const CueVolumes& volumes, int angle, const SearchTask& task);

}  // namespace objectness

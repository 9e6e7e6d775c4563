// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "common/parallel.hpp"

namespace objectness {

/// Calls work(first, last) for bands of rows first..last-1 that together are 0..rows-1, on up to `threads` threads. A
/// band writes only to what belongs to its rows.
template <class Work>
void forRowBands(int rows, int threads, Work&& work, int rows_per_band = 32) {
  const int bands = (rows + rows_per_band - 1) / rows_per_band;
  parallelFor(bands, threads,
              [&](int band) { work(band * rows_per_band, std::min(rows, (band + 1) * rows_per_band)); });
}

}  // namespace objectness

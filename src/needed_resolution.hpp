// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/thread_pool.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/result.hpp"
#include "scene/resolution.hpp"

namespace objectness {

/// Brings what was found in averageBlocks(frame, factor) = coarse to the pixels of the frame. Table, boxes and all that
/// is metric stay; normals, which only the stages need, go.
void spreadOverPixels(const Frame& frame, const Frame& coarse, int factor, int threads, Segmentation& result);

/// Calls run(frame to work on), which fills the result: with the frame itself, or where its pixels are finer than
/// needed with one of averaged pixels, on the threads of a pool. The result is of the frame's size either way, also
/// when a stage fails or throws.
template <class Run>
void atNeededResolution(const Frame& frame, const Config& config, Segmentation& result, const Run& run) {
  const int factor = averagedPixels(frame, config.resolution), threads = config.runtime.threads;
  const ThreadPool pool(threads);
  if (factor == 1) {
    run(frame);
    return;
  }
  const Frame coarse = [&] {
    const StageTimer timer(result.report.timings_ms, "averaging");
    return averageBlocks(frame, factor, threads);
  }();
  try {
    run(coarse);
  } catch (...) {
    spreadOverPixels(frame, coarse, factor, threads, result);
    throw;
  }
  const StageTimer timer(result.report.timings_ms, "spreading");
  spreadOverPixels(frame, coarse, factor, threads, result);
}

}  // namespace objectness

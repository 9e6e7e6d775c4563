// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <exception>
#include <string>
#include <vector>

#include "frame_methods.hpp"
#include "peak_memory.hpp"
#include "scene_store.hpp"

namespace objectness::benchmarks {

/// How often each thing is measured; every repetition is one run.
struct Repetitions {
  int frames = 7, scans = 3, plain = 1;
};

/// The work of a benchmark; an exception fails it alone.
template <class Work>
auto guarded(Work work) {
  return [work](benchmark::State& state) {
    try {
      work(state);
    } catch (const std::exception& e) {
      state.SkipWithError(e.what());
    }
  };
}

// Names are PART/KIND/VOLUME/SCENE, e.g. "search/plain/wide/learn0"; the report is made from them.

/// "frame/METHOD/VOLUME/SCENE": wall and CPU time of a whole frame, kThreads threads, once it is warm. Counters: stages
/// ("stage:NN:NAME", ms, in order), what was counted ("count:NAME"), peak_mib.
void registerFrames(const BenchmarkScene& scene, const PeakMemory& memory, bool with_baselines,
                    const Repetitions& repetitions);

/// What an exhaustive search costs, over all angles:
/// - "search/plain|scan|bounded/VOLUME/SCENE": CPU time of one thread, volumes not counted. A search that does not
///   find the same boxes as the first to be run fails. plain and scan: with_oracles.
/// - "volumes/all/VOLUME/SCENE": CPU time of one thread to build the volumes.
/// - "angles/all/VOLUME/SCENE": wall time of both with kThreads threads, as in a frame.
/// Counters: boxes (sampled), passed, scored.
void registerSearches(const BenchmarkScene& scene, bool with_oracles, const Repetitions& repetitions);

}  // namespace objectness::benchmarks

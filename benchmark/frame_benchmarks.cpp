// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "registration.hpp"

namespace objectness::benchmarks {
namespace {

void addCounters(const Segmentation& result, benchmark::State& state) {
  // Counters come out sorted by name: the number keeps the order of the stages.
  int stage = 10;
  for (const auto& [name, ms] : result.report.timings_ms) {
    state.counters["stage:" + std::to_string(stage++) + ":" + name] = ms;
  }
  Report::figures(result.report, [&](const std::string& name, const auto& figure) {
    // Of runs that all counted 0 the coefficient of variation is no number, which JSON cannot hold.
    if (figure && *figure != 0) state.counters["count:" + name] = static_cast<double>(*figure);
  });
}

}  // namespace

void registerFrames(const BenchmarkScene& scene, const PeakMemory& memory, bool with_baselines,
                    const Repetitions& repetitions) {
  for (const FrameMethod& method : frameMethods()) {
    if (method.is_baseline && !with_baselines) continue;
    const double peak_mib = memory.mib(scene, method);
    // Buffers and the model are there from the second frame on, as they are for a camera.
    const auto warm = std::make_shared<bool>(false);
    const auto run = [=](benchmark::State& state) {
      const Frame& frame = frameOf(scene);
      if (!*warm) method.run(frame);
      *warm = true;
      Segmentation result;
      for (auto _ : state) result = method.run(frame);
      if (!result.status.ok()) return state.SkipWithError(result.status.message.c_str());
      addCounters(result, state);
      if (peak_mib > 0) state.counters["peak_mib"] = peak_mib;
    };
    const std::string name = "frame/" + method.name + "/" + method.volume + "/" + scene.source.name;
    benchmark::RegisterBenchmark(name.c_str(), guarded(run))
        ->Iterations(1)
        ->Repetitions(repetitions.frames)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace objectness::benchmarks

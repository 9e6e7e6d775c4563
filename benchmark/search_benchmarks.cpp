// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <optional>

#include "reference/plain_search.hpp"
#include "registration.hpp"
#include "search/bounded_search.hpp"
#include "search/scan_search.hpp"
#include "search_input.hpp"

namespace objectness::benchmarks {
namespace {

bool same(const ScoredBox& a, const ScoredBox& b) { return a.box == b.box && a.objectness == b.objectness; }

/// What the benchmarks of one scene and volume share; made by the first of them that is run, gone with the last.
class SharedInput {
 public:
  SharedInput(const BenchmarkScene& scene, const Config& config) : scene_(scene), config_(config) {}

  const SearchInput& get() {
    // One at a time: volumes of the scenes before are not needed again.
    static SharedInput* latest = nullptr;
    if (latest && latest != this) latest->input_.reset();
    latest = this;
    if (!input_) input_.emplace(frameOf(scene_), config_);
    return *input_;
  }

  /// Whether these are the boxes that the first search found.
  bool agrees(const std::vector<ScoredBox>& boxes) {
    if (!boxes_) boxes_ = boxes;
    return std::equal(boxes.begin(), boxes.end(), boxes_->begin(), boxes_->end(), same);
  }

 private:
  BenchmarkScene scene_;
  Config config_;
  std::optional<SearchInput> input_;
  std::optional<std::vector<ScoredBox>> boxes_;
};

benchmark::internal::Benchmark* oneRun(benchmark::internal::Benchmark* added, int repetitions) {
  return added->Iterations(1)->Repetitions(repetitions)->Unit(benchmark::kMillisecond);
}

/// search: null for the volumes alone.
void registerOnOneThread(const std::string& name, Search search, int repetitions,
                         const std::shared_ptr<SharedInput>& shared) {
  const auto run = [=](benchmark::State& state) {
    const SearchInput& input = shared->get();
    SearchResult result;
    for (auto _ : state) {
      const SearchTimes times = input.run(search, result);
      state.SetIterationTime(search ? times.search : times.volumes);
    }
    if (!search) return;
    if (!shared->agrees(result.boxes)) return state.SkipWithError("does not find the same boxes as the other searches");
    state.counters["boxes"] = static_cast<double>(result.sampled);
    state.counters["scored"] = static_cast<double>(result.scored);
    state.counters["nodes"] = static_cast<double>(result.nodes);
    state.counters["passed"] = static_cast<double>(result.boxes.size());
  };
  oneRun(benchmark::RegisterBenchmark(name.c_str(), guarded(run)), repetitions)->UseManualTime();
}

void registerOnAllThreads(const std::string& name, int repetitions, const std::shared_ptr<SharedInput>& shared) {
  const auto run = [=](benchmark::State& state) {
    const SearchInput& input = shared->get();
    SearchOutcome outcome;
    for (auto _ : state) outcome = input.searchAll();
    state.counters["boxes"] = static_cast<double>(outcome.sampled);
    state.counters["passed"] = static_cast<double>(outcome.passed);
  };
  oneRun(benchmark::RegisterBenchmark(name.c_str(), guarded(run)), repetitions)->MeasureProcessCPUTime()->UseRealTime();
}

}  // namespace

void registerSearches(const BenchmarkScene& scene, bool with_oracles, const Repetitions& repetitions) {
  for (const auto& [volume, config] : volumesOfInterest()) {
    const auto shared = std::make_shared<SharedInput>(scene, config);
    const std::string suffix = "/" + volume + "/" + scene.source.name;
    if (with_oracles) {
      registerOnOneThread("search/plain" + suffix, searchPlain, repetitions.plain, shared);
      registerOnOneThread("search/scan" + suffix, searchScan, repetitions.scans, shared);
    }
    registerOnOneThread("search/bounded" + suffix, searchBounded, repetitions.frames, shared);
    registerOnOneThread("volumes/all" + suffix, nullptr, repetitions.frames, shared);
    registerOnAllThreads("angles/all" + suffix, repetitions.frames, shared);
  }
  for (const auto& [volume, config] : strictVolumes()) {
    const auto shared = std::make_shared<SharedInput>(scene, config);
    registerOnAllThreads("angles/strict/" + volume + "/" + scene.source.name, repetitions.frames, shared);
  }
}

}  // namespace objectness::benchmarks

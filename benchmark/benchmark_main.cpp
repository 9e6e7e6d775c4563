// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "common/frame_memory.hpp"
#include "evaluation/commit.hpp"
#include "evaluation/machine.hpp"
#include "options.hpp"
#include "progress_reporter.hpp"
#include "registration.hpp"
#include "tools/tool_message.hpp"

using namespace objectness;
using namespace objectness::benchmarks;

namespace {

enum ExitStatus { kDone = 0, kFailed = 1, kUsageError = 2 };

/// Of the pictures in which all is compared; in larger and smaller ones only the package itself is measured.
constexpr int kComparedWidth_px = 640;

ExitStatus complain(ExitStatus status, const std::string& message) {
  printToolMessage("benchmark_objectness", message);
  return status;
}

/// What was measured, where and from which sources.
bool saveRun(const Options& options, const std::vector<BenchmarkScene>& scenes) {
  double load = -1;
  getloadavg(&load, 1);
  nlohmann::ordered_json run{{"machine", evaluation::describeMachine()},
                             {"compiler", COMPILER},
                             {"commit", evaluation::commit()},
                             {"threads", kThreads},
                             {"load_before", load},
                             {"repetitions",
                              {{"frames", options.repetitions.frames},
                               {"scan", options.repetitions.scans},
                               {"plain", options.repetitions.plain}}}};
  for (const BenchmarkScene& scene : scenes) {
    run["scenes"].push_back({{"name", scene.source.name},
                             {"group", scene.source.group},
                             {"objects", scene.objects},
                             {"width", scene.width},
                             {"height", scene.height}});
  }
  std::ofstream file(options.out + "/run.json");
  file << run.dump(2) << '\n';
  return file.good();
}

/// Google Benchmark writes DIR/benchmark.json.
void initializeLibrary(const Options& options, const std::string& program) {
  static std::vector<std::string> words;  // the library keeps the name of the program
  words = {program, "--benchmark_out=" + options.out + "/benchmark.json", "--benchmark_out_format=json"};
  words.insert(words.end(), options.for_library.begin(), options.for_library.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

int main(int argc, char** argv) {
  keepFrameMemory();  // as all programs that segment
  const Result<Options> parsed = parseOptions(argc, argv);
  if (!parsed.ok()) return complain(kUsageError, parsed.status.message + " (benchmark_objectness --help)");
  const Options& options = parsed.value;
  if (!options.print.empty()) {
    std::cout << options.print << std::flush;
    return kDone;
  }
  const Result<std::vector<BenchmarkScene>> scenes = findBenchmarkScenes(options.scenes);
  if (!scenes.ok()) return complain(kFailed, scenes.status.message);
  if (!options.alone.empty()) return runAlone(options.alone, scenes.value.front()) ? kDone : kFailed;
  if (!saveRun(options, scenes.value)) return complain(kFailed, "cannot write into the folder " + options.out);

  PeakMemory memory;
  if (options.memory) memory.measure(scenes.value, frameMethods());
  initializeLibrary(options, argv[0]);
  for (const BenchmarkScene& scene : scenes.value) {
    const bool compared = scene.width == kComparedWidth_px;
    registerFrames(scene, memory, compared, options.repetitions);
    registerSearches(scene, compared, options.repetitions);
  }
  ProgressReporter progress;
  benchmark::RunSpecifiedBenchmarks(&progress);
  return kDone;
}

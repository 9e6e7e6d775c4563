// SPDX-License-Identifier: BSD-3-Clause
#include "progress_reporter.hpp"

#include <algorithm>
#include <cstdio>

namespace objectness::benchmarks {

void ProgressReporter::ReportRuns(const std::vector<Run>& runs) {
  std::vector<double> times;
  for (const Run& run : runs) {
    if (run.run_type == Run::RT_Iteration) times.push_back(run.GetAdjustedRealTime());
  }
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  // "/iterations:1/repeats:7/..." is the same for all of a kind.
  const std::string name = runs.front().benchmark_name();
  std::printf("%10.1f ms  %s\n", times[times.size() / 2], name.substr(0, name.find("/iterations")).c_str());
  std::fflush(stdout);
}

}  // namespace objectness::benchmarks

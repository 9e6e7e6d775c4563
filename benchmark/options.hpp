// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "registration.hpp"

namespace objectness::benchmarks {

struct Options {
  std::string print;  ///< the help, when it was asked for
  std::string alone;  ///< a method that is to be run once: runAlone()
  std::string out;
  std::vector<std::string> scenes;
  Repetitions repetitions;
  bool memory = true;
  std::vector<std::string> for_library;  ///< --benchmark_*, for Google Benchmark
};

/// kBadConfig: a wrong command line.
Result<Options> parseOptions(int argc, const char* const* argv);

}  // namespace objectness::benchmarks

// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include <boost/program_options.hpp>
#include <sstream>

#include "tools/command_line.hpp"

namespace objectness::benchmarks {
namespace {

namespace po = boost::program_options;

constexpr const char* kIntroduction =
    "Measures the stages and the searches of the package beside PCL's segmenters; scripts/benchmark calls it.\n"
    "\n"
    "  benchmark_objectness [--quick] [--repetitions N] [--benchmark_OPTION ...] --out DIR SCENES...\n"
    "\n"
    "SCENES are scene folders with truth, or folders of such. DIR/benchmark.json is Google Benchmark's own report,\n"
    "DIR/run.json says what was measured where. The nested loop is run once. The plain searches and\n"
    "PCL's segmenters are measured in pictures 640 wide only.\n"
    "\n";

po::options_description shownOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  add("out", po::value<std::string>()->value_name("DIR"), "folder for the report, which must be there");
  add("repetitions", po::value<int>()->value_name("N"), "runs of each frame and bounded search (7)");
  add("quick", po::bool_switch(), "two runs of everything, no peak memory");
  add("alone", po::value<std::string>()->value_name("METHOD/VOLUME"),
      "only run this method once in the scene: peak memory is that of such a process");
  add("help,h", po::bool_switch(), "print this");
  return options;
}

bool isForLibrary(const std::string& argument) { return argument.rfind("--benchmark_", 0) == 0; }

}  // namespace

Result<Options> parseOptions(int argc, const char* const* argv) {
  Result<Options> parsed;
  Options& options = parsed.value;
  std::vector<const char*> own;
  for (int i = 0; i < argc; ++i) {
    if (i > 0 && isForLibrary(argv[i])) {
      options.for_library.push_back(argv[i]);
    } else {
      own.push_back(argv[i]);
    }
  }
  try {
    const po::options_description shown = shownOptions();
    const po::variables_map values = parseCommandLine(static_cast<int>(own.size()), own.data(), shown, Inputs::kAny);
    if (values["help"].as<bool>()) {
      std::ostringstream help;
      help << kIntroduction << shown;
      options.print = help.str();
      return parsed;
    }
    options.alone = textOf(values, "alone");
    options.out = textOf(values, "out");
    options.scenes = listOf(values, "input");
    if (values["quick"].as<bool>()) {
      options.repetitions = {2, 1, 1};
      options.memory = false;
    }
    if (values.count("repetitions")) options.repetitions.frames = values["repetitions"].as<int>();
  } catch (const po::error& e) {
    return Result<Options>::error(StatusCode::kBadConfig, e.what());
  }
  if (options.out.empty() && options.alone.empty())
    return Result<Options>::error(StatusCode::kBadConfig, "--out DIR is needed");
  if (options.scenes.empty()) return Result<Options>::error(StatusCode::kBadConfig, "no scenes are given");
  if (options.repetitions.frames < 1) {
    return Result<Options>::error(StatusCode::kBadConfig, "--repetitions needs a number above 0");
  }
  return parsed;
}

}  // namespace objectness::benchmarks

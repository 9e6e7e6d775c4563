// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/machine.hpp"

#include <pcl/pcl_config.h>
#include <unistd.h>

#include <fstream>
#include <opencv2/core/version.hpp>
#include <thread>

namespace objectness::evaluation {
namespace {

/// What follows `key` and the separator in the first such line of a file, without quotes; empty when there is none.
std::string valueOf(const char* path, const std::string& key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    std::size_t from = line.find(separator);
    if (from == std::string::npos) continue;
    from = line.find_first_not_of(" \"", from + 1);
    if (from == std::string::npos) continue;
    return line.substr(from, line.find_last_not_of(" \"") + 1 - from);
  }
  return "";
}

}  // namespace

std::string describeMachine() {
  const std::string processor = valueOf("/proc/cpuinfo", "model name", ':'),
                    system = valueOf("/etc/os-release", "PRETTY_NAME", '=');
  const double memory_gib =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / (1 << 30);
  return (processor.empty() ? "unknown processor" : processor) + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " threads, " +
         std::to_string(static_cast<int>(memory_gib + 0.5)) + " GiB; " + (system.empty() ? "" : system + "; ") +
         "PCL " PCL_VERSION_PRETTY ", OpenCV " CV_VERSION;
}

}  // namespace objectness::evaluation

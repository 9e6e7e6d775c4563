// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace objectness_test {

/// A number of /proc/PID/status, in kB; 0 when there is no such process.
inline long statusOf(pid_t process, const std::string& key) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, key.size() + 1, key + ":") == 0) return std::stol(line.substr(key.size() + 1));
  }
  return 0;
}

inline long residentKb(pid_t process) { return statusOf(process, "VmRSS"); }

inline long threadCount(pid_t process) { return statusOf(process, "Threads"); }

}  // namespace objectness_test

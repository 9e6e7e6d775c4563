// SPDX-License-Identifier: BSD-3-Clause
#include "io/quiet_pcl.hpp"

#include <pcl/console/print.h>

#include <mutex>

namespace objectness {
namespace {

std::mutex mutex;
int living = 0;
pcl::console::VERBOSITY_LEVEL level_before = pcl::console::L_INFO;

}  // namespace

QuietPcl::QuietPcl() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (living++ > 0) return;
  level_before = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

QuietPcl::~QuietPcl() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (--living == 0) pcl::console::setVerbosityLevel(level_before);
}

}  // namespace objectness

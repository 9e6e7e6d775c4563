// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace objectness_segmentation {

/// Tells whether a problem is to be said (again). Problems that differ in numbers only are the same. Not
/// NODELET_WARN_THROTTLE: that one counts for all nodelets of a manager together, and in ROS time. Thread safe.
class ThrottledProblems {
 public:
  bool isDue(const std::string& problem) {
    std::string kind;
    for (const char c : problem) {
      if (!std::isdigit(static_cast<unsigned char>(c))) kind += c;
    }
    std::lock_guard<std::mutex> lock(mutex_);
    if (last_.size() > kMaxKinds) last_.clear();
    const auto now = std::chrono::steady_clock::now();
    const auto [last, first_time] = last_.emplace(kind, now);
    if (!first_time && now - last->second < kPeriod) return false;
    last->second = now;
    return true;
  }

 private:
  static constexpr std::chrono::seconds kPeriod{10};
  static constexpr std::size_t kMaxKinds = 200;

  std::mutex mutex_;
  std::map<std::string, std::chrono::steady_clock::time_point> last_;
};

}  // namespace objectness_segmentation

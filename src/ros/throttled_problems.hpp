// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <chrono>
#include <iterator>
#include <map>
#include <mutex>
#include <string>

namespace objectness_segmentation {

/// Tells whether a problem is to be said (again): each kind once in ten seconds, however its text changes. Not
/// NODELET_WARN_THROTTLE: that one counts for all nodelets of a manager together, and in ROS time. Thread safe.
class ThrottledProblems {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPeriod{10};
  /// So many different texts of one group are said in a period: any number of them may come.
  static constexpr int kMaxTexts = 5;

  bool isDue(const std::string& kind, Clock::time_point now = Clock::now()) {
    std::lock_guard<std::mutex> lock(mutex_);
    return isDueLocked(kind, now);
  }

  /// Of a group of kinds that only their text tells apart: those that differ in numbers only are the same.
  bool isTextDue(const std::string& group, const std::string& text, Clock::time_point now = Clock::now()) {
    std::string kind = group + ": ";
    for (const char c : text) {
      if (!std::isdigit(static_cast<unsigned char>(c))) kind += c;
    }
    std::lock_guard<std::mutex> lock(mutex_);
    Group& said = groups_[group];
    if (now - said.start >= kPeriod) said = {now, 0};
    if (said.texts >= kMaxTexts || !isDueLocked(kind, now)) return false;
    ++said.texts;
    return true;
  }

 private:
  struct Group {
    Clock::time_point start;
    int texts = 0;
  };
  static constexpr std::size_t kMaxKinds = 200;

  bool isDueLocked(const std::string& kind, Clock::time_point now) {
    if (last_.size() > kMaxKinds) forgetOld(now);
    const auto [last, first_time] = last_.emplace(kind, now);
    if (!first_time && now - last->second < kPeriod) return false;
    last->second = now;
    return true;
  }
  void forgetOld(Clock::time_point now) {
    for (auto kind = last_.begin(); kind != last_.end();) {
      kind = now - kind->second >= kPeriod ? last_.erase(kind) : std::next(kind);
    }
  }

  std::mutex mutex_;
  std::map<std::string, Clock::time_point> last_;
  std::map<std::string, Group> groups_;
};

}  // namespace objectness_segmentation

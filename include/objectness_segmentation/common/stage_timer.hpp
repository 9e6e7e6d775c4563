// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace objectness {

/// Wall-clock milliseconds per stage, in the order the stages ran.
using StageTimes = std::vector<std::pair<std::string, double>>;

/// Adds the time between construction and destruction to `times` under `stage`.
class StageTimer {
 public:
  StageTimer(StageTimes& times, std::string stage)
      : times_(times), stage_(std::move(stage)), start_(std::chrono::steady_clock::now()) {}
  ~StageTimer() {
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start_;
    try {
      times_.emplace_back(std::move(stage_), elapsed.count());
    } catch (const std::exception&) {  // out of memory: the time is lost, the process is not
    }
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  StageTimes& times_;
  std::string stage_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace objectness

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "evaluation/experiment.hpp"

namespace objectness::evaluation {

/// Tells the user on standard error how far an experiment is: a bar on a terminal, else a line at every tenth of it,
/// and a line for each problem.
class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const Progress& progress);

 private:
  std::string remaining(const Progress& progress) const;

  const bool terminal_;
  const std::chrono::steady_clock::time_point start_;
  int tenths_shown_ = 0;
};

/// "evaluate: `message`" on a line of standard error.
void printLine(const std::string& message);

}  // namespace objectness::evaluation

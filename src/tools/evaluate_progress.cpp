// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "tools/tool_message.hpp"

namespace objectness::evaluation {
namespace {

constexpr int kBarWidth = 30, kMinute_s = 60, kHour_s = 3600;
constexpr const char* kEraseLine = "\r\033[K";

std::string durationText(double seconds) {
  const int s = static_cast<int>(seconds + 0.5);
  if (s < kMinute_s) return std::to_string(s) + " s";
  if (s < kHour_s) return std::to_string(s / kMinute_s) + " min " + std::to_string(s % kMinute_s) + " s";
  return std::to_string(s / kHour_s) + " h " + std::to_string(s % kHour_s / kMinute_s) + " min";
}

std::string bar(const Progress& progress) {
  const int full = kBarWidth * progress.done / std::max(1, progress.total);
  return "[" + std::string(full, '#') + std::string(kBarWidth - full, '.') + "] " + std::to_string(progress.done) +
         "/" + std::to_string(progress.total);
}

}  // namespace

ProgressDisplay::ProgressDisplay() : terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {}

ProgressDisplay::~ProgressDisplay() {
  if (terminal_) std::cerr << kEraseLine << std::flush;
}

std::string ProgressDisplay::remaining(const Progress& progress) const {
  if (progress.computed == 0 || progress.done == progress.total) return "";
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  return ", " + durationText(elapsed.count() / progress.computed * (progress.total - progress.done)) + " left";
}

void ProgressDisplay::show(const Progress& progress) {
  if (terminal_) std::cerr << kEraseLine;
  if (!progress.result && progress.done > 0) {
    printLine(std::to_string(progress.done) + " of " + std::to_string(progress.total) +
              " results are there from an earlier run");
  }
  if (progress.result && !progress.result->problem.empty()) {
    const bool failed = progress.result->state == SceneResult::State::kFailed;
    printLine(progress.result->scene + ", " + progress.result->method + ": " + progress.result->problem +
              (failed ? " (counts as nothing found)" : " (not counted)"));
  }
  if (terminal_) {
    std::cerr << bar(progress) << remaining(progress)
              << (progress.result ? "  " + progress.result->method + " " + progress.result->scene : "") << std::flush;
    return;
  }
  const int tenths = 10 * progress.done / std::max(1, progress.total);
  if (!progress.result || tenths == tenths_shown_) return;
  tenths_shown_ = tenths;
  printLine(std::to_string(progress.done) + " of " + std::to_string(progress.total) + " done" + remaining(progress));
}

void printLine(const std::string& message) { printToolMessage("evaluate", message); }

}  // namespace objectness::evaluation

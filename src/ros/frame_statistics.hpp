// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "objectness_segmentation/common/stage_timer.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness_segmentation {

/// What happened to the frames since the last snapshot, for the diagnostics. Thread safe; wall time only, so that it
/// works under simulated time and looping bags. No ROS in it.
class FrameStatistics {
 public:
  struct Snapshot {
    double seconds = 0;  ///< time it covers
    double input_hz = 0, output_hz = 0;
    double mean_latency_ms = 0, max_latency_ms = 0;  ///< from take-up to result
    double seconds_since_input = 0;                  ///< since the last frame, or since resetInputAge()
    objectness::Status last_status;
    std::size_t last_objects = 0;
    std::int64_t last_boxes_scored = 0;     ///< boxes or groups that the objects were chosen among
    std::string last_remark;                ///< what was wrong with the last input, but not in the way
    objectness::StageTimes mean_stages_ms;  ///< of the frames with results, in the order they ran
    std::string exception;  ///< of the last frame that ended with one; empty once a frame succeeded after it
  };

  FrameStatistics() : start_(Clock::now()), last_input_(start_) {}

  void countInput();
  void countOutput(const objectness::Status& status, std::size_t objects, double latency_ms);
  /// Of the frame that is counted next.
  void noteStages(const objectness::StageTimes& stages_ms, std::int64_t boxes_scored);
  void noteRemark(const std::string& remark);
  void noteException(const std::string& what);
  /// Input is expected from now on.
  void resetInputAge();

  /// Returns what was gathered and resets.
  Snapshot take();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  Clock::time_point start_, last_input_;
  std::uint64_t inputs_ = 0, outputs_ = 0;
  double latency_sum_ms_ = 0, max_latency_ms_ = 0;
  objectness::Status last_status_;
  std::size_t last_objects_ = 0;
  std::int64_t last_boxes_scored_ = 0;
  std::string last_remark_;
  std::vector<std::pair<std::string, std::pair<double, int>>> stage_sums_ms_;  // sum and number of each
  std::string exception_;
};

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#include "ros/frame_statistics.hpp"

#include <algorithm>

namespace objectness_segmentation {

void FrameStatistics::countInput() {
  std::lock_guard<std::mutex> lock(mutex_);
  ++inputs_;
  last_input_ = Clock::now();
}

void FrameStatistics::countOutput(const objectness::Status& status, std::size_t objects, double latency_ms) {
  std::lock_guard<std::mutex> lock(mutex_);
  ++outputs_;
  latency_sum_ms_ += latency_ms;
  max_latency_ms_ = std::max(max_latency_ms_, latency_ms);
  last_status_ = status;
  last_objects_ = objects;
  if (status.code != objectness::StatusCode::kInternalError) exception_.clear();
}

void FrameStatistics::noteStages(const objectness::StageTimes& stages_ms, std::int64_t boxes_scored) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_boxes_scored_ = boxes_scored;
  for (const auto& [stage, milliseconds] : stages_ms) {
    auto known = std::find_if(stage_sums_ms_.begin(), stage_sums_ms_.end(),
                              [name = stage](const auto& sum) { return sum.first == name; });
    if (known == stage_sums_ms_.end()) known = stage_sums_ms_.insert(known, {stage, {0.0, 0}});
    known->second.first += milliseconds;
    ++known->second.second;
  }
}

void FrameStatistics::noteRemark(const std::string& remark) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_remark_ = remark;
}

void FrameStatistics::noteException(const std::string& what) {
  std::lock_guard<std::mutex> lock(mutex_);
  exception_ = what;
}

void FrameStatistics::resetInputAge() {
  std::lock_guard<std::mutex> lock(mutex_);
  last_input_ = Clock::now();
}

FrameStatistics::Snapshot FrameStatistics::take() {
  std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  Snapshot snapshot;
  snapshot.seconds = std::chrono::duration<double>(now - start_).count();
  if (snapshot.seconds > 0) {
    snapshot.input_hz = static_cast<double>(inputs_) / snapshot.seconds;
    snapshot.output_hz = static_cast<double>(outputs_) / snapshot.seconds;
  }
  if (outputs_ > 0) snapshot.mean_latency_ms = latency_sum_ms_ / static_cast<double>(outputs_);
  snapshot.max_latency_ms = max_latency_ms_;
  snapshot.seconds_since_input = std::chrono::duration<double>(now - last_input_).count();
  snapshot.last_status = last_status_;
  snapshot.last_objects = last_objects_;
  snapshot.last_boxes_scored = last_boxes_scored_;
  snapshot.last_remark = last_remark_;
  for (const auto& [stage, sum] : stage_sums_ms_) snapshot.mean_stages_ms.emplace_back(stage, sum.first / sum.second);
  snapshot.exception = exception_;
  start_ = now;
  inputs_ = outputs_ = 0;
  latency_sum_ms_ = max_latency_ms_ = 0;
  stage_sums_ms_.clear();
  return snapshot;
}

}  // namespace objectness_segmentation

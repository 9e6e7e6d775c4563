// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>

namespace objectness_segmentation {

/// Hands fresh results from the worker to the service threads that wait for them. No ROS in it; thread safe.
///
/// A frame is told at its arrival which requests it is new enough for (newestAnsweredBy()); its result then answers all
/// of these (answer()). So a frame that was on its way when the request came is not taken for an answer.
template <class Answer>
class PendingRequests {
 public:
  /// Number of the newest request that a frame answers; 0: none.
  using RequestId = std::uint64_t;

  struct OldFrames {
    std::uint32_t count = 0;
    double age_s = 0;  ///< of the last one when it came: stamp behind the clock of the requests
  };

  /// A request that is made now, by the clock of the stamps. Ends with its guard.
  class Request {
   public:
    Request(PendingRequests& requests, double now_s) : requests_(requests), number_(requests.open(now_s)) {}
    ~Request() { requests_.close(number_); }
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;

    /// The answer; none when the (wall) time is over or the requests is closed before it comes.
    std::optional<Answer> wait(double seconds) { return requests_.wait(number_, seconds); }

    /// The frames that came since the request and were not new enough for it.
    OldFrames oldFrames() const { return requests_.oldFrames(number_); }

   private:
    PendingRequests& requests_;
    RequestId number_;
  };

  bool pending() const { return pending_ > 0; }
  bool stopped() const { return stop_; }

  /// For a frame that arrives now. Stamps of another clock than now_s (kForeign_s or more away) cannot be compared with
  /// the time of the request: then what arrives after it is new enough.
  RequestId newestAnsweredBy(double stamp_s, double now_s) {
    std::lock_guard<std::mutex> lock(mutex_);
    const double age_s = now_s - stamp_s;
    const bool comparable = age_s < kForeign_s && age_s > -kForeign_s;
    RequestId request_id = 0;
    for (auto& [number, request] : open_) {
      if (!comparable || stamp_s >= request.time_s) {
        request_id = number;
      } else {
        request.old_frames = {request.old_frames.count + 1, age_s};
      }
    }
    return request_id;
  }

  /// Whether a frame with this request_id still has somebody waiting.
  bool wants(RequestId request_id) const {
    std::lock_guard<std::mutex> lock(mutex_);
    return !open_.empty() && open_.begin()->first <= request_id;
  }

  void answer(RequestId request_id, const Answer& answer) {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      for (auto& [number, request] : open_) {
        if (number <= request_id && !request.answer) request.answer = answer;
      }
    }
    wake_.notify_all();
  }

  /// Ends all waiting, now and in future.
  void stop() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      stop_ = true;
    }
    wake_.notify_all();
  }

 private:
  static constexpr double kForeign_s = 10;

  struct Open {
    double time_s = 0;
    std::optional<Answer> answer;
    OldFrames old_frames;
  };

  RequestId open(double now_s) {
    std::lock_guard<std::mutex> lock(mutex_);
    open_[++last_].time_s = now_s;
    ++pending_;
    return last_;
  }
  void close(RequestId number) {
    std::lock_guard<std::mutex> lock(mutex_);
    open_.erase(number);
    --pending_;
  }
  std::optional<Answer> wait(RequestId number, double seconds) {
    std::unique_lock<std::mutex> lock(mutex_);
    Open& request = open_.at(number);  // a map's elements stay where they are
    wake_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return stop_ || request.answer; });
    return request.answer;
  }
  OldFrames oldFrames(RequestId number) const {
    std::lock_guard<std::mutex> lock(mutex_);
    return open_.at(number).old_frames;
  }

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<RequestId, Open> open_;
  RequestId last_ = 0;
  std::atomic<int> pending_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace objectness_segmentation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace objectness_segmentation {

/// One thread that works on the newest job only: a job that arrives while another one waits replaces it and the
/// replaced one is counted as dropped. So the age of what is worked on is bounded by the time of one job, whatever the
/// input rate. No ROS in it. All methods are thread safe; none but stop() blocks for the time of a job.
template <class Job>
class LatestOnlyWorker {
 public:
  using Process = std::function<void(const Job&)>;
  using OnException = std::function<void(const std::string& what)>;

  /// process runs in the worker's thread; what it throws ends that job only and is handed to on_exception, in the same
  /// thread. process should watch stopFlag() when a job takes long.
  LatestOnlyWorker(Process process, OnException on_exception)
      : process_(std::move(process)), on_exception_(std::move(on_exception)), thread_([this] { run(); }) {}
  ~LatestOnlyWorker() { stop(); }
  LatestOnlyWorker(const LatestOnlyWorker&) = delete;
  LatestOnlyWorker& operator=(const LatestOnlyWorker&) = delete;

  /// Puts the job into the mailbox. After stop() it is ignored.
  void submit(Job job) {
    std::optional<Job> replaced;  // destroyed outside the lock: a job may hold megabytes
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (stop_) return;
      if (waiting_) ++dropped_;
      replaced = std::exchange(waiting_, std::optional<Job>(std::move(job)));
    }
    wake_.notify_one();
  }

  /// Forgets the waiting job, which counts as dropped.
  void discardWaiting() {
    std::optional<Job> discarded;
    std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_) ++dropped_;
    discarded.swap(waiting_);
  }

  /// Lets the running job end, forgets the waiting one and joins the thread. May be called again.
  void stop() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      stop_ = true;
      waiting_.reset();
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  /// Becomes true with stop(): for jobs that can end early.
  const std::atomic<bool>& stopFlag() const { return stop_; }

  std::uint32_t dropped() const { return dropped_; }

 private:
  void run() {
    while (true) {
      std::optional<Job> job;
      {
        std::unique_lock<std::mutex> lock(mutex_);
        wake_.wait(lock, [this] { return stop_ || waiting_; });
        if (stop_) return;
        job.swap(waiting_);
      }
      try {
        process_(*job);
      } catch (const std::exception& e) {
        report(e.what());
      } catch (...) {
        report("an exception that is no std::exception");
      }
    }
  }

  void report(const std::string& what) noexcept {
    try {
      on_exception_(what);
    } catch (...) {  // nobody is left to tell, and the thread has to live on
    }
  }

  Process process_;
  OnException on_exception_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Job> waiting_;
  std::atomic<bool> stop_{false};
  std::atomic<std::uint32_t> dropped_{0};
  std::thread thread_;  // last: starts when everything it uses exists
};

}  // namespace objectness_segmentation

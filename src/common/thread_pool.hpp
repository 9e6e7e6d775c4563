// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace objectness {

/// The threads that help the one that made it, until it is destroyed: none is left behind. parallelFor() calls from
/// that thread use them instead of starting threads of their own. A thread that waits looks out for a tenth of a
/// millisecond before it sleeps: to be woken takes as long, and the next loop of a frame mostly begins earlier.
class ThreadPool {
 public:
  /// threads: with the caller; 0: one per processor. Fewer when there are no more to be had.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls work(i) for i = 0..count-1 on up to `threads` threads, the caller's included. Rethrows the first exception
  /// when no call runs any more.
  void run(int count, int threads, const std::function<void(int)>& work);

  /// The pool that the calling thread has made last and not destroyed; nullptr without one.
  static ThreadPool* current();
  /// Whether the calling thread is at work for a pool: what it calls in parallel in turn, it does alone.
  static bool isHelping();

  static int resolve(int threads);  ///< 0: one per processor

 private:
  void help();
  void work();

  ThreadPool* const outer_;
  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  // Written under the mutex, and looked at without it by who has not gone to sleep yet.
  std::atomic<bool> stop_{false};
  std::atomic<int> running_{0};
  std::atomic<unsigned> job_{0};
  int wanted_ = 0;

  // The job: written by run() before it wakes anyone.
  const std::function<void(int)>* call_ = nullptr;
  int count_ = 0;
  std::atomic<int> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
};

}  // namespace objectness

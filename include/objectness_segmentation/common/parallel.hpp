// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace objectness {

/// Calls work(i) for i = 0..count-1 on up to `threads` threads, the caller's included; 0: one per processor. The order
/// is not fixed, so work(i) writes only to what belongs to i. The first exception is rethrown after all threads have
/// joined.
template <class Work>
void parallelFor(int count, int threads, Work&& work) {
  if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::atomic<bool> failed{false};
  const auto run = [&] {
    try {
      for (int i = next++; i < count && !failed; i = next++) work(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  try {
    for (int i = 1; i < threads && i < count; ++i) workers.emplace_back(run);
  } catch (const std::exception&) {
    // No more threads to be had: those that started and this one do the work.
  }
  run();
  for (auto& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace objectness
